open Scc_base

type t = int array

(* Products of two numbers below 2^31 fit an int. *)
let rec power p a n =
  if n = 0 then 1
  else
    let half = power p (a * a mod p) (n / 2) in
    if n land 1 = 1 then half * a mod p else half

(* Miller and Rabin's test. To these bases it errs for no number below 3 215 031 751 (Pomerance, Selfridge and
   Wagstaff, "The pseudoprimes to 25 10^9", 1980). *)
let is_prime n =
  let rec odd d s = if d land 1 = 1 then (d, s) else odd (d / 2) (s + 1) in
  let passes a =
    let d, s = odd (n - 1) 0 in
    let rec squares x i = x = n - 1 || (i < s && squares (x * x mod n) (i + 1)) in
    let x = power n a d in
    a mod n = 0 || x = 1 || squares x 1
  in
  n = 2 || (n > 2 && n land 1 = 1 && List.for_all passes [ 2; 3; 5; 7 ])

let rec prime_below n = if is_prime (n - 1) then n - 1 else prime_below (n - 1)
let first_prime = 0x7fffffff

let inverse p a =
  let rec go r s r' s' = if r' = 0 then s else let q = r / r' in go r' s' (r - (q * r')) (s - (q * s')) in
  let s = go a 1 p 0 in
  if s < 0 then s + p else s

let residue p z = Z.to_int (Z.erem z (Z.of_int p))

let reduce p (x : Rat.t) =
  match residue p x.den with 0 -> None | d -> Some (residue p x.num * inverse p d mod p)

let trim (a : t) =
  let rec top i = if i > 0 && a.(i - 1) = 0 then top (i - 1) else i in
  let n = top (Array.length a) in
  if n = Array.length a then a else Array.sub a 0 n

let degree (a : t) = Array.length a - 1

let scale p k (a : t) : t = Array.map (fun c -> c * k mod p) a

(* Quotient and remainder; the divisor is not zero. *)
let divide p (a : t) (b : t) =
  let d = degree b in
  let r = Array.copy a and q = Array.make (Int.max 0 (degree a - d + 1)) 0 in
  let top = inverse p b.(d) in
  for i = degree a - d downto 0 do
    let k = r.(i + d) * top mod p in
    q.(i) <- k;
    if k <> 0 then
      for j = 0 to d do
        let x = r.(i + j) - (k * b.(j) mod p) in
        r.(i + j) <- (if x < 0 then x + p else x)
      done
  done;
  (q, trim r)

(* a - q b *)
let less p (a : t) (q : t) (b : t) =
  let n = Int.max (Array.length a) (Array.length q + Array.length b - 1) in
  let r = Array.init n (fun i -> if i < Array.length a then a.(i) else 0) in
  Array.iteri
    (fun i k ->
       if k <> 0 then
         Array.iteri
           (fun j c ->
              let x = r.(i + j) - (k * c mod p) in
              r.(i + j) <- (if x < 0 then x + p else x))
           b)
    q;
  trim r

(* A common factor over the integers is one modulo p, of the same degree, unless p divides a leading coefficient.
*)
let coprime a b =
  let p = first_prime in
  let last x = x.(Array.length x - 1) in
  let a = Array.map (residue p) a and b = Array.map (residue p) b in
  let rec gcd (a : t) (b : t) = if Array.length b = 0 then a else gcd b (snd (divide p a b)) in
  last a <> 0 && last b <> 0 && degree (gcd a b) = 0

(* The polynomial through the points, by divided differences; and the product of all x - point. *)
let through p ~at ~values =
  let n = Array.length at in
  let c = Array.copy values in
  for k = 1 to n - 1 do
    for i = n - 1 downto k do
      let d = c.(i) - c.(i - 1) and e = at.(i) - at.(i - k) in
      let positive x = if x < 0 then x + p else x in
      c.(i) <- positive d * inverse p (positive e) mod p
    done
  done;
  let value = Array.make n 0 and product = Array.make (n + 1) 0 in
  product.(0) <- 1;
  for k = 0 to n - 1 do
    for i = 0 to k do
      value.(i) <- (value.(i) + (c.(k) * product.(i) mod p)) mod p
    done;
    (* times x - at(k) *)
    for i = k + 1 downto 0 do
      let below = if i > 0 then product.(i - 1) else 0 in
      let x = below - (product.(i) * at.(k) mod p) in
      product.(i) <- (if x < 0 then x + p else x)
    done
  done;
  (trim value, product)

(* Cauchy's interpolation. Along Euclid's scheme for the product of all x - point and the polynomial through the
   points, each remainder r = s product + t value gives the fraction r/t, and deg r + deg t is the number of
   points minus the degree of the next quotient. So a fraction of low degree comes before a quotient of high
   degree. One whose denominator vanishes at a point says nothing of the value there, and is passed over. *)
let fraction p ~at ~values =
  let value, product = through p ~at ~values in
  let spare = 3 in
  let finish (r : t) (t : t) =
    let k = inverse p t.(degree t) in
    let r = scale p k r and t = scale p k t in
    let rec at_point (a : t) x i sum = if i < 0 then sum else at_point a x (i - 1) (((sum * x) + a.(i)) mod p) in
    let vanishes x = at_point t x (degree t) 0 = 0 in
    if Array.exists vanishes at then None else Some (r, t)
  in
  let rec go (r : t) (t : t) (r' : t) (t' : t) =
    if Array.length r' = 0 then (
      (* The value 0 everywhere. *)
      if degree r >= spare && degree t' <= 0 then finish r' t' else None)
    else
      let q, next = divide p r r' in
      let go_on () = go r' t' next (less p t q t') in
      if degree q < spare then go_on () else match finish r' t' with Some pair -> Some pair | None -> go_on ()
  in
  if Array.length at <> Array.length values then Bug.fail __POS__ "points without values"
  else go product [||] value [| 1 |]
