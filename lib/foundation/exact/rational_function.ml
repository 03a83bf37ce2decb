open Scc_base

type t = { numerator : Polynomial.t; denominator : Polynomial.t }

let numerator f = f.numerator
let denominator f = f.denominator
let one_polynomial = Polynomial.one

(* Integer coefficients without a common factor of all of them, and a positive leading one below. *)
let coprime n d =
  if Polynomial.is_zero d then Bug.fail __POS__ "a rational function with the denominator 0"
  else if Polynomial.is_zero n then { numerator = n; denominator = one_polynomial }
  else
    let leading p = List.nth (Polynomial.coefficients p) (Polynomial.degree p) in
    let scale p = Rat.div (leading (Polynomial.primitive p)) (leading p) in
    (* n = a n', d = b d' for primitive n' and d', and a/b = x/y in lowest terms. *)
    let ratio = Rat.div (scale d) (scale n) in
    let ratio = if Rat.sign (leading d) > 0 then ratio else Rat.neg ratio in
    let d' = Polynomial.primitive d in
    let d' = if Rat.sign (leading d') > 0 then d' else Polynomial.neg d' in
    let whole z = Rat.make z Z.one in
    {
      numerator = Polynomial.scale (whole ratio.num) (Polynomial.primitive n);
      denominator = Polynomial.scale (whole ratio.den) d';
    }

let make n d =
  let g = Polynomial.gcd n d in
  if Polynomial.degree g < 1 then coprime n d
  else coprime (fst (Polynomial.divide n g)) (fst (Polynomial.divide d g))

let of_polynomial p = coprime p one_polynomial
let zero = of_polynomial Polynomial.zero
let one = of_polynomial one_polynomial
let variable = of_polynomial Polynomial.variable
let constant c = of_polynomial (Polynomial.constant c)

let to_constant f =
  match (Polynomial.to_constant f.numerator, Polynomial.to_constant f.denominator) with
  | Some n, Some d -> Some (Rat.div n d)
  | _ -> None

let add f g =
  if Polynomial.equal f.denominator g.denominator then make (Polynomial.add f.numerator g.numerator) f.denominator
  else
    make
      (Polynomial.add
         (Polynomial.mul f.numerator g.denominator)
         (Polynomial.mul g.numerator f.denominator))
      (Polynomial.mul f.denominator g.denominator)

let neg f = { f with numerator = Polynomial.neg f.numerator }
let sub f g = add f (neg g)

let mul f g =
  make (Polynomial.mul f.numerator g.numerator) (Polynomial.mul f.denominator g.denominator)

let div f g =
  make (Polynomial.mul f.numerator g.denominator) (Polynomial.mul f.denominator g.numerator)

(* b^n p(a/b), for a polynomial of degree at most n with integer coefficients. *)
let homogeneous p n (x : Rat.t) =
  let rec go cs power sum =
    match cs with
    | [] -> (sum, power)
    | (c : Rat.t) :: rest -> go rest (Z.mul power x.den) (Z.add (Z.mul sum x.num) (Z.mul c.num power))
  in
  (* From the highest coefficient down, those of degrees above that of p being 0. *)
  let sum, _ = go (List.rev (Polynomial.coefficients p)) Z.one Z.zero in
  Z.mul sum (Z.pow x.den (n - Int.max 0 (Polynomial.degree p)))

let degree f = Int.max 0 (Int.max (Polynomial.degree f.numerator) (Polynomial.degree f.denominator))

let eval f x =
  let n = degree f in
  let d = homogeneous f.denominator n x in
  if Z.sign d = 0 then None else Some (Rat.make (homogeneous f.numerator n x) d)

let passes f x (y : Rat.t) =
  let n = degree f in
  let d = homogeneous f.denominator n x in
  Z.sign d <> 0 && Z.equal (Z.mul (homogeneous f.numerator n x) y.den) (Z.mul d y.num)

let slope f =
  Polynomial.sub
    (Polynomial.mul (Polynomial.derivative f.numerator) f.denominator)
    (Polynomial.mul f.numerator (Polynomial.derivative f.denominator))

let derivative f = make (slope f) (Polynomial.mul f.denominator f.denominator)

let compare f g =
  let order p q = List.compare Rat.compare (Polynomial.coefficients p) (Polynomial.coefficients q) in
  match order f.numerator g.numerator with 0 -> order f.denominator g.denominator | c -> c

let equal f g = compare f g = 0

let hash f =
  let add h c = (31 * h) + Rat.hash c in
  let of_polynomial h p = List.fold_left add h (Polynomial.coefficients p) in
  of_polynomial (of_polynomial 17 f.numerator) f.denominator

let bits f =
  let of_polynomial p = List.fold_left (fun n c -> n + Rat.bits c) 0 (Polynomial.coefficients p) in
  of_polynomial f.numerator + of_polynomial f.denominator

let terms p = List.length (List.filter (fun c -> Rat.sign c <> 0) (Polynomial.coefficients p))

let to_string ~variable f =
  let text p = Polynomial.to_string ~variable p in
  match Polynomial.to_constant f.denominator with
  | Some d -> text (Polynomial.scale (Rat.div Rat.one d) f.numerator)
  | None ->
    let within p = if terms p > 1 then "(" ^ text p ^ ")" else text p in
    let below p =
      (* 2k below a line would be read as a product with what is above. *)
      if terms p > 1 || not (Polynomial.degree p = 1 && String.equal (text p) variable) then "(" ^ text p ^ ")"
      else text p
    in
    within f.numerator ^ "/" ^ below f.denominator
