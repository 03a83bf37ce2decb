open Scc_base

type t = { polynomial : Polynomial.t; low : Rat.t; high : Rat.t; coefficients : Z.t array }

(* [binomials n]: C(n, 0) to C(n, n). *)
let binomials n =
  let row = Array.make (n + 1) Z.one in
  for i = 1 to n do
    row.(i) <- Z.divexact (Z.mul row.(i - 1) (Z.of_int (n + 1 - i))) (Z.of_int i)
  done;
  row

(* Integers in proportion to the coefficients. *)
let integral p =
  let c = Array.of_list (Polynomial.coefficients p) in
  let one q = Z.equal (Q.den q) Z.one in
  if Array.for_all one c then Array.map Q.num c
  else
    let d = Array.fold_left (fun d q -> if one q then d else Z.lcm d (Q.den q)) Z.one c in
    Array.map (fun q -> Z.mul (Q.num q) (Z.divexact d (Q.den q))) c

(* In proportion to p(low + (high - low) x), by powers of x. With low = a/d and high = (a + w)/d that is
   sum c_i d^(n - i) (a + w x)^i, by Horner's scheme. *)
let shifted c low high =
  let d = Z.lcm (Q.den low) (Q.den high) in
  let over q = Z.mul (Q.num q) (Z.divexact d (Q.den q)) in
  let a = over low in
  let w = Z.sub (over high) a in
  let n = Array.length c - 1 in
  let r = Array.make (n + 1) Z.zero in
  r.(0) <- c.(n);
  let power = ref Z.one in
  for i = n - 1 downto 0 do
    power := Z.mul !power d;
    for j = n - i downto 1 do
      r.(j) <- Z.add (Z.mul a r.(j)) (Z.mul w r.(j - 1))
    done;
    r.(0) <- Z.add (Z.mul a r.(0)) (Z.mul c.(i) !power)
  done;
  r

(* x^i = sum over j >= i of C(j, i)/C(n, i) times the Bernstein polynomial j; made integral by the least common
   multiple of the C(n, i). *)
let of_powers r =
  let n = Array.length r - 1 in
  let c = binomials n in
  let common = Array.fold_left Z.lcm Z.one c in
  let b = Array.make (n + 1) Z.zero in
  Array.iteri
    (fun i a ->
       if Z.sign a <> 0 then begin
         let a = ref (Z.mul a (Z.divexact common c.(i))) in
         for j = i to n do
           (* [a] is C(j, i) times what it was *)
           b.(j) <- Z.add b.(j) !a;
           a := Z.divexact (Z.mul !a (Z.of_int (j + 1))) (Z.of_int (j + 1 - i))
         done
       end)
    r;
  b

let make polynomial ~low ~high =
  if Rat.compare low high >= 0 then Bug.fail __POS__ "Bernstein coefficients over an empty interval";
  let coefficients =
    if Polynomial.is_zero polynomial then [| Z.zero |]
    else of_powers (shifted (integral polynomial) low high)
  in
  { polynomial; low; high; coefficients }

(* De Casteljau's scheme without its divisions by two: after k rounds the numbers are 2^k times too great. *)
let halve p =
  let n = Array.length p.coefficients - 1 in
  let b = Array.copy p.coefficients in
  let left = Array.make (n + 1) Z.zero and right = Array.make (n + 1) Z.zero in
  for k = 0 to n do
    left.(k) <- Z.shift_left b.(0) (n - k);
    right.(n - k) <- Z.shift_left b.(n - k) (n - k);
    for i = 0 to n - k - 1 do
      b.(i) <- Z.add b.(i) b.(i + 1)
    done
  done;
  let m = Rat.middle p.low p.high in
  ({ p with high = m; coefficients = left }, { p with low = m; coefficients = right })

let variations p =
  let step (last, n) c =
    match Z.sign c with 0 -> (last, n) | s -> (s, if last * s < 0 then n + 1 else n)
  in
  snd (Array.fold_left step (0, 0) p.coefficients)

let first_sign sign c = if sign <> 0 then sign else Z.sign c

(* Right after the low end the first coefficient that is not zero tells the sign. *)
let sign_after_low p = Array.fold_left first_sign 0 p.coefficients
let sign_before_high p = Array.fold_right (fun c sign -> first_sign sign c) p.coefficients 0
let sign_at_low p = Z.sign p.coefficients.(0)
let sign_at_high p = Z.sign p.coefficients.(Array.length p.coefficients - 1)

type root = Exactly of Rat.t | Inside of t

let rational r = Exactly r
let low = function Exactly r -> r | Inside p -> p.low
let high = function Exactly r -> r | Inside p -> p.high

(* Both halves together have no more changes of sign than the whole: one, whose root lies in the half that has
   it. When neither has it, the root is the middle: else a half would have a root without a change of sign. *)
let bisect p =
  let l, r = halve p in
  if variations l = 1 then Inside l else if variations r = 1 then Inside r else Exactly l.high

(* The root of a piece with one change of sign. *)
let rec settle p =
  if sign_at_low p <> 0 && sign_at_high p <> 0 then Inside p
  else match bisect p with Exactly r -> Exactly r | Inside p -> settle p

let rec narrow root ~width =
  match root with
  | Exactly _ -> root
  | Inside p -> if Rat.compare (Rat.sub p.high p.low) width <= 0 then root else narrow (bisect p) ~width

(* On simple roots alone, so that halving comes to an end (Vincent's theorem). *)
let roots p ~low ~high =
  if Polynomial.is_zero p then Bug.fail __POS__ "the roots of the zero polynomial";
  let rec search p found =
    match variations p with
    | 0 -> found
    | 1 -> settle p :: found
    | _ ->
      let l, r = halve p in
      let found = search r found in
      search l (if sign_at_low r = 0 then Exactly r.low :: found else found)
  in
  if Rat.compare low high >= 0 then [] else search (make (Polynomial.square_free p) ~low ~high) []

let compare_rational p r =
  if Rat.compare r p.low <= 0 then 1
  else if Rat.compare r p.high >= 0 then -1
  else
    match Polynomial.sign_at p.polynomial r with
    | 0 -> 0
    | s -> if s = sign_at_low p then 1 else -1

(* Whether a divisor of the polynomial of a root vanishes at it, the root lying in an interval with ends where the
   divisor does not vanish: the root is simple and the only one, also of the divisor. *)
let vanishes divisor ~low ~high =
  Polynomial.degree divisor >= 1 && Polynomial.sign_at divisor low * Polynomial.sign_at divisor high < 0

(* After so many halvings two roots are taken to be equal, which is then decided. *)
let patience = 16

let rec compare_within n x y =
  match (x, y) with
  | Exactly a, Exactly b -> Rat.compare a b
  | Inside p, Exactly r -> compare_rational p r
  | Exactly r, Inside p -> -compare_rational p r
  | Inside p, Inside q ->
    if Rat.compare p.high q.low <= 0 then -1
    else if Rat.compare q.high p.low <= 0 then 1
    else if n = patience && vanishes (Polynomial.gcd p.polynomial q.polynomial)
              ~low:(Rat.max p.low q.low) ~high:(Rat.min p.high q.high)
    then 0 (* each end of the common interval is one of p or of q, where their common divisor is not zero *)
    else compare_within (n + 1) (bisect p) (bisect q)

let compare x y = compare_within 0 x y

let to_algebraic root ~scale ~shift =
  let place x = Rat.add shift (Rat.mul scale x) in
  match root with
  | Exactly r -> Algebraic.of_rat (place r)
  | Inside p ->
    let back = Rat.div Rat.one scale in
    let polynomial = Polynomial.substitute p.polynomial ~scale:back ~shift:(Rat.neg (Rat.mul back shift)) in
    Algebraic.isolated polynomial ~low:(place p.low) ~high:(place p.high)

type first = Nowhere | At_once | Later of root

(* So many halvings are tried before multiple roots, which no halving isolates, are looked for. *)
let plain_depth = 5

(* From the left. [odd] has the sign of [p] at all points but finitely many; its roots are simple, so halving
   isolates them. *)
let rec search odd p depth =
  match (sign_after_low p, variations p) with
  | 0, _ | 1, 0 -> Nowhere
  | 1, 1 -> Later (settle p)
  | 1, _ ->
    let p =
      if depth <> plain_depth then p
      else
        let odd = Lazy.force odd in
        if Polynomial.degree odd = Polynomial.degree p.polynomial then p
        else make odd ~low:p.low ~high:p.high
    in
    if depth = plain_depth && variations p <= 1 then search odd p (depth + 1)
    else begin
      let l, r = halve p in
      match search odd l (depth + 1) with
      | Nowhere -> (
          match search odd r (depth + 1) with
          | At_once -> Later (Exactly r.low)
          | (Nowhere | Later _) as found -> found)
      | (At_once | Later _) as found -> found
    end
  | _ -> At_once

let from_rational odd p ~low ~until =
  if Rat.compare low until >= 0 then Nowhere else search odd (make p ~low ~high:until) 0

(* From the high end of an interval around an instant on; it counts as later. *)
let go_on odd p ~low ~until =
  match from_rational odd p ~low ~until with
  | At_once -> Later (Exactly low)
  | (Nowhere | Later _) as found -> found

(* [p] is simple at its roots: whether it has the sign [s] right after the root. *)
let rec settle_after odd p ~after ~until =
  match after with
  | Exactly low -> from_rational odd p ~low ~until
  | Inside at -> (
      let here = make p ~low:at.low ~high:at.high in
      match variations here with
      | 0 -> if sign_after_low here < 0 then At_once else go_on odd p ~low:at.high ~until
      | 1 when vanishes (Polynomial.gcd at.polynomial p) ~low:at.low ~high:at.high ->
        if sign_before_high here < 0 then At_once else go_on odd p ~low:at.high ~until
      | _ -> settle_after odd p ~after:(bisect at) ~until)

let first_negative p ~after ~until =
  let odd = lazy (Polynomial.odd_part p) in
  match after with
  | Exactly low -> from_rational odd p ~low ~until
  | Inside at ->
    let here = make p ~low:at.low ~high:at.high in
    if variations here > 0 then settle_after odd (Lazy.force odd) ~after ~until
    else if sign_after_low here < 0 then At_once
    else go_on odd p ~low:at.high ~until
