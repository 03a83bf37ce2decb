type t =
  | Rational of Rat.t
  | Irrational of { polynomial : Polynomial.t; low : Rat.t; high : Rat.t }

let of_rat r = Rational r
let zero = Rational Rat.zero

let of_root = function
  | Polynomial.Exactly r -> Rational r
  | Polynomial.Within { polynomial; low; high } -> Irrational { polynomial; low; high }

let roots p ~low ~high = List.map of_root (Polynomial.roots p ~low ~high)
let isolated p ~low ~high = of_root (Polynomial.isolated p ~low ~high)
let to_rat = function Rational r -> Some r | Irrational _ -> None
let low_end = function Rational r -> r | Irrational i -> i.low
let high_end = function Rational r -> r | Irrational i -> i.high

(* One bisection. The middle is no root: the only root inside is irrational. *)
let halve = function
  | Rational r -> Rational r
  | Irrational { polynomial; low; high } ->
    let m = Rat.middle low high in
    if Polynomial.sign_at polynomial m = Polynomial.sign_at polynomial low then
      Irrational { polynomial; low = m; high }
    else Irrational { polynomial; low; high = m }

let compare_rat a r =
  match a with
  | Rational x -> Rat.compare x r
  | Irrational { polynomial; low; high } ->
    if Rat.compare r low <= 0 then 1
    else if Rat.compare r high >= 0 then -1
    else if Polynomial.sign_at polynomial r = Polynomial.sign_at polynomial low then 1
    else -1

(* Whether a divisor of the polynomial of an isolated root vanishes at it: it can have no other root in
   the interval, and this one is simple. *)
let divisor_vanishes g low high =
  Polynomial.degree g >= 1 && Polynomial.sign_at g low * Polynomial.sign_at g high < 0

let rec separate a b =
  if Rat.compare (high_end a) (low_end b) <= 0 then -1
  else if Rat.compare (high_end b) (low_end a) <= 0 then 1
  else separate (halve a) (halve b)

let compare a b =
  match (a, b) with
  | x, Rational r -> compare_rat x r
  | Rational r, x -> -compare_rat x r
  | Irrational x, Irrational y ->
    let low = Rat.max x.low y.low and high = Rat.min x.high y.high in
    if Rat.compare low high >= 0 then separate a b
    else
      (* The ends of the common interval are ends of one of the two, where the divisor does not
         vanish. *)
      let g = Polynomial.gcd x.polynomial y.polynomial in
      if divisor_vanishes g low high then 0 else separate a b

let equal a b = compare a b = 0

(* [q] has a definite sign over the closed interval once it has no root there. *)
let rec settle q chain a =
  let low = low_end a and high = high_end a in
  let s = Polynomial.sign_at q low in
  if s <> 0 && Polynomial.count chain low high = 0 then s else settle q chain (halve a)

let sign_at q a =
  match (a, Polynomial.to_constant q) with
  | _, Some c -> Rat.sign c
  | Rational r, None -> Polynomial.sign_at q r
  | Irrational { polynomial; low; high }, None ->
    if divisor_vanishes (Polynomial.gcd polynomial q) low high then 0
    else settle q (Polynomial.sturm (Polynomial.square_free q)) a

let rec between a b =
  match (a, b) with
  | Rational x, Rational y when Rat.compare x y >= 0 -> Scc_base.Bug.fail __POS__ "nothing lies between"
  | _ ->
    let h = high_end a and l = low_end b in
    let c = Rat.compare h l in
    if c < 0 then Rat.middle h l
    else
      match (a, b) with
      | Irrational _, Irrational _ when c = 0 -> h
      | _ ->
        if compare a b >= 0 then Scc_base.Bug.fail __POS__ "nothing lies between"
        else between (halve a) (halve b)

let rec enclose a ~width =
  let low = low_end a and high = high_end a in
  if Rat.compare (Rat.sub high low) width <= 0 then (low, high) else enclose (halve a) ~width

(* p(t - r) by Horner's scheme. *)
let shift p r =
  let base = Polynomial.of_coefficients [ Rat.neg r; Rat.one ] in
  List.fold_right
    (fun c acc -> Polynomial.add (Polynomial.constant c) (Polynomial.mul base acc))
    (Polynomial.coefficients p) Polynomial.zero

let add_rat r = function
  | Rational x -> Rational (Rat.add r x)
  | Irrational { polynomial; low; high } ->
    Irrational
      { polynomial = Polynomial.primitive (shift polynomial r); low = Rat.add r low; high = Rat.add r high }

let ten_to n = Rat.make (Z.pow (Z.of_int 10) n) Z.one

(* An irrational number is nowhere between two decimals: near enough, both ends round to the same. *)
let rec to_decimal ?(digits = 6) a =
  let low = Decimal.padded ~places:digits (low_end a) and high = Decimal.padded ~places:digits (high_end a) in
  if String.equal low high then low else to_decimal ~digits (halve a)

(* The interval shown is the coarsest of neighbouring multiples of 10^-k, k >= 1, that isolates the root,
   so that the text does not depend on how far the number happens to be refined. *)
let rec shown chain a k =
  let unit = ten_to k in
  let rec floor_of a =
    let x = Rat.floor (Rat.mul (low_end a) unit) and y = Rat.floor (Rat.mul (high_end a) unit) in
    let top_is_end = Rat.equal (Rat.make y Z.one) (Rat.mul (high_end a) unit) in
    if Z.equal x y || (top_is_end && Z.equal (Z.succ x) y) then x else floor_of (halve a)
  in
  let n = floor_of a in
  let low = Rat.div (Rat.make n Z.one) unit and high = Rat.div (Rat.make (Z.succ n) Z.one) unit in
  if Polynomial.count chain low high = 1 then (low, high) else shown chain a (k + 1)

let to_string ?variable a =
  match a with
  | Rational r -> Rat.to_string r
  | Irrational { polynomial; _ } ->
    let low, high = shown (Polynomial.sturm polynomial) a 1 in
    Printf.sprintf "root of %s in (%s, %s), about %s"
      (Polynomial.to_string ?variable polynomial) (Rat.to_string low) (Rat.to_string high) (to_decimal a)
