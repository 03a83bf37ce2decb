(* Coefficients from the constant up; the last one is not zero. *)
type t = Rat.t array

let trim a =
  let rec top i = if i > 0 && Rat.sign a.(i - 1) = 0 then top (i - 1) else i in
  let n = top (Array.length a) in
  if n = Array.length a then a else Array.sub a 0 n

let zero = [||]
let constant c = trim [| c |]
let one = constant Rat.one
let variable = [| Rat.zero; Rat.one |]
let of_coefficients l = trim (Array.of_list l)
let coefficients = Array.to_list
let degree p = Array.length p - 1
let is_zero p = Array.length p = 0

let to_constant p =
  match Array.length p with 0 -> Some Rat.zero | 1 -> Some p.(0) | _ -> None

let leading p =
  if is_zero p then Scc_base.Bug.fail __POS__ "the zero polynomial has no leading coefficient"
  else p.(Array.length p - 1)

let coefficient p i = if i < Array.length p then p.(i) else Rat.zero

let add p q =
  let length = Int.max (Array.length p) (Array.length q) in
  trim (Array.init length (fun i -> Rat.add (coefficient p i) (coefficient q i)))

let neg p = Array.map Rat.neg p
let sub p q = add p (neg q)
let scale k p = if Rat.sign k = 0 then zero else Array.map (Rat.mul k) p

let mul p q =
  if is_zero p || is_zero q then zero
  else begin
    let r = Array.make (Array.length p + Array.length q - 1) Rat.zero in
    Array.iteri (fun i a -> Array.iteri (fun j b -> r.(i + j) <- Rat.add r.(i + j) (Rat.mul a b)) q) p;
    r
  end

let derivative p =
  if degree p < 1 then zero
  else Array.init (Array.length p - 1) (fun i -> Rat.mul (Rat.of_int (i + 1)) p.(i + 1))

let eval p x = Array.fold_right (fun c acc -> Rat.add c (Rat.mul x acc)) p Rat.zero
let sign_at p x = Rat.sign (eval p x)

let equal p q =
  Array.length p = Array.length q
  && Array.for_all (fun x -> x) (Array.mapi (fun i a -> Rat.equal a q.(i)) p)

let divide a b =
  let d = degree b in
  let top = leading b in
  let r = Array.copy a in
  let q = Array.make (Int.max 0 (degree a - d + 1)) Rat.zero in
  for i = degree a - d downto 0 do
    let k = Rat.div r.(i + d) top in
    q.(i) <- k;
    if Rat.sign k <> 0 then
      Array.iteri (fun j c -> r.(i + j) <- Rat.sub r.(i + j) (Rat.mul k c)) b
  done;
  (trim q, trim r)

let primitive p =
  if is_zero p then zero
  else
    let denominator = Array.fold_left (fun acc c -> Z.lcm acc (Q.den c)) Z.one p in
    let content =
      Array.fold_left
        (fun acc c -> Z.gcd acc (Z.mul (Q.num c) (Z.divexact denominator (Q.den c))))
        Z.zero p
    in
    scale (Rat.make denominator content) p

let positive p = if is_zero p || Rat.sign (leading p) > 0 then p else neg p

let rec euclid a b = if is_zero b then a else euclid b (primitive (snd (divide a b)))

(* Euclid's scheme over the integers takes long where there is nothing to find, which one prime shows. *)
let long = 8

let gcd a b =
  let a = primitive a and b = primitive b in
  let integers = Array.map (fun (c : Rat.t) -> c.num) in
  if degree a >= long && degree b >= long && Modular.coprime (integers a) (integers b) then one
  else positive (primitive (euclid a b))

let square_free p =
  let p = primitive p in
  if degree p <= 1 then p
  else
    let g = gcd p (derivative p) in
    if degree g = 0 then p else primitive (fst (divide p g))

(* With p = p_1 p_2^2 p_3^3 ..., the p_i without common and multiple roots: g = gcd(p, p') is p_2 p_3^2 ..., p/g is
   p_1 p_2 p_3 ..., and the odd part of g, which is p_2 p_4 ..., divides it. The leading coefficient of g,
   hence of its odd part, is positive, so that signs are those of p. *)
let rec odd_part p =
  let p = primitive p in
  if degree p <= 1 then p
  else
    let g = gcd p (derivative p) in
    if degree g = 0 then p else primitive (fst (divide (fst (divide p g)) (odd_part g)))

let substitute p ~scale:k ~shift =
  let linear = trim [| shift; k |] in
  Array.fold_right (fun c acc -> add (constant c) (mul linear acc)) p zero

(* Cauchy: every root is at most 1 + max |c_i / c_n| in magnitude, and strictly below one more. *)
let root_bound p =
  let top = leading p in
  let greatest = Array.fold_left (fun acc c -> Rat.max acc (Rat.abs (Rat.div c top))) Rat.zero p in
  Rat.of_int 2 |> Rat.add (Rat.make (Rat.floor greatest) Z.one)

type sturm = t list

let sturm p =
  let rec chain a b acc =
    if is_zero b then List.rev (a :: acc) else chain b (primitive (neg (snd (divide a b)))) (a :: acc)
  in
  chain (primitive p) (primitive (derivative p)) []

let variations chain x =
  let step (last, n) p =
    let s = sign_at p x in
    if s = 0 then (last, n) else (s, if last * s < 0 then n + 1 else n)
  in
  snd (List.fold_left step (0, 0) chain)

let count chain a b = variations chain a - variations chain b

type root =
  | Exactly of Rat.t
  | Within of { polynomial : t; low : Rat.t; high : Rat.t }

let inside ~low ~high x =
  Rat.compare low x < 0 && match high with None -> true | Some h -> Rat.compare x h < 0

(* p = a t^2 + b t + c over the integers: the roots (-b -+ sqrt D) / 2a are rational exactly when D is a
   square, and otherwise the integer square root encloses them. *)
let quadratic_roots p =
  let a = Q.num p.(2) and b = Q.num p.(1) and c = Q.num p.(0) in
  let d = Z.sub (Z.mul b b) (Z.mul (Z.of_int 4) (Z.mul a c)) in
  if Z.sign d < 0 then []
  else
    let s, rest = Z.sqrt_rem d in
    let over n = Rat.make n (Z.mul (Z.of_int 2) a) in
    if Z.sign rest = 0 then
      [ Exactly (over (Z.neg (Z.add b s))); Exactly (over (Z.sub s b)) ]
    else
      let between m n =
        let x = over m and y = over n in
        Within { polynomial = p; low = Rat.min x y; high = Rat.max x y }
      in
      [ between (Z.neg (Z.add b (Z.succ s))) (Z.neg (Z.add b s)); between (Z.sub s b) (Z.sub (Z.succ s) b) ]

(* What a look at an interval without roots at its ends gives: its roots, or a rational root found, which
   is divided out before the search starts afresh. *)
type look = Isolated of root list | Rational of Rat.t

let rec narrow p sign_low low high width =
  if Rat.compare (Rat.sub high low) width < 0 then Ok (low, high)
  else
    let m = Rat.middle low high in
    let s = sign_at p m in
    if s = 0 then Error m
    else if s = sign_low then narrow p sign_low m high width
    else narrow p sign_low low m width

(* A rational root of a primitive integer polynomial has a denominator that divides the leading
   coefficient: an interval narrower than its inverse holds at most one candidate. *)
let single p low high =
  let top = Q.num (leading p) in
  match narrow p (sign_at p low) low high (Rat.make Z.one (Z.abs top)) with
  | Error r -> Rational r
  | Ok (low, high) ->
    let scale = Rat.make (Z.abs top) Z.one in
    let candidate = Rat.div (Rat.make (Z.succ (Rat.floor (Rat.mul low scale))) Z.one) scale in
    if inside ~low ~high:(Some high) candidate && sign_at p candidate = 0 then Rational candidate
    else Isolated [ Within { polynomial = p; low; high } ]

let rec look p chain low high =
  match count chain low high with
  | 0 -> Isolated []
  | 1 -> single p low high
  | _ -> (
      let m = Rat.middle low high in
      if sign_at p m = 0 then Rational m
      else
        match look p chain low m with
        | Rational r -> Rational r
        | Isolated left -> (
            match look p chain m high with
            | Rational r -> Rational r
            | Isolated right -> Isolated (left @ right)))

let divide_out p r = primitive (fst (divide p [| Rat.neg r; Rat.one |]))

let rec general p ~low ~high rationals =
  if degree p <= 2 then (simple p, rationals)
  else if sign_at p low = 0 then general (divide_out p low) ~low ~high rationals
  else if sign_at p high = 0 then general (divide_out p high) ~low ~high rationals
  else
    match look p (sturm p) low high with
    | Isolated l -> (l, rationals)
    | Rational r -> general (divide_out p r) ~low ~high (r :: rationals)

and simple p =
  match degree p with
  | 0 -> []
  | 1 -> [ Exactly (Rat.neg (Rat.div p.(0) p.(1))) ]
  | 2 -> quadratic_roots p
  | _ -> Scc_base.Bug.fail __POS__ "degree above two"

(* A rational root of an integer polynomial is one modulo a prime too, unless the prime divides its denominator
   and so the leading coefficient. A prime without a root proves that all roots are irrational. *)
let proves_irrational p prime =
  let modulo c = Z.to_int (Z.erem (Q.num c) (Z.of_int prime)) in
  let c = Array.map modulo p in
  let rec no_root x =
    x = prime || (Array.fold_right (fun c acc -> ((acc * x) + c) mod prime) c 0 <> 0 && no_root (x + 1))
  in
  c.(Array.length c - 1) <> 0 && no_root 0

let primes = [ 3; 5; 7; 11; 13; 17; 19; 23; 29; 31; 37; 41; 43; 47; 53; 59; 61 ]

let compare_rational_root r = function
  | Exactly x -> Rat.compare r x
  | Within { polynomial; low; high } ->
    if Rat.compare r low <= 0 then -1
    else if Rat.compare r high >= 0 then 1
    else if sign_at polynomial r = sign_at polynomial low then -1
    else 1

let compare_roots a b =
  match (a, b) with
  | Exactly x, root -> compare_rational_root x root
  | root, Exactly x -> -compare_rational_root x root
  | Within x, Within y -> Rat.compare x.low y.low

let in_range ~low ~high root =
  compare_rational_root low root < 0
  && match high with None -> true | Some h -> compare_rational_root h root > 0

let isolated p ~low ~high =
  let p = positive (square_free p) in
  if degree p <= 2 then
    match List.filter (in_range ~low ~high:(Some high)) (simple p) with
    | [ root ] -> root
    | _ -> Scc_base.Bug.fail __POS__ "the root is not alone"
  else if List.exists (proves_irrational p) primes then Within { polynomial = p; low; high }
  else
    match single p low high with
    | Rational r -> Exactly r
    | Isolated [ root ] -> root
    | Isolated _ -> Scc_base.Bug.fail __POS__ "the root is not alone"

let roots p ~low ~high =
  if is_zero p then Scc_base.Bug.fail __POS__ "the zero polynomial has no isolated roots"
  else
    let p = positive (square_free p) in
    let finite = match high with Some h -> h | None -> Rat.max (root_bound p) (Rat.add low Rat.one) in
    if Rat.compare low finite >= 0 then []
    else
      let found, rationals = general p ~low ~high:finite [] in
      List.map (fun r -> Exactly r) rationals @ found
      |> List.filter (in_range ~low ~high)
      |> List.sort compare_roots

let term ~variable i c =
  let c = Rat.abs c in
  let power = match i with 0 -> "" | 1 -> variable | _ -> Printf.sprintf "%s^%d" variable i in
  if i = 0 then Rat.to_string c
  else if Rat.equal c Rat.one then power
  else if Rat.is_integer c then Rat.to_string c ^ power
  else Printf.sprintf "(%s)%s" (Rat.to_string c) power

let to_string ?(variable = "t") p =
  let terms = List.rev (List.mapi (fun i c -> (i, c)) (Array.to_list p)) in
  let terms = List.filter (fun (_, c) -> Rat.sign c <> 0) terms in
  let show first (i, c) =
    let minus = Rat.sign c < 0 in
    let glue = if first then if minus then "-" else "" else if minus then " - " else " + " in
    glue ^ term ~variable i c
  in
  match terms with
  | [] -> "0"
  | first :: rest -> String.concat "" (show true first :: List.map (show false) rest)
