open Scc_exact

type t = Chance of Rat.t | Open_chance of Open_number.t | Rate of { rate : Rat.t; alone : Rat.t }

let compare a b =
  match (a, b) with
  | Chance p, Chance q -> Rat.compare p q
  | Open_chance m, Open_chance n -> Rational_function.compare m.form n.form
  | Rate r, Rate s -> Rat.compare r.rate s.rate
  | Chance _, (Open_chance _ | Rate _) | Open_chance _, Rate _ -> -1
  | (Open_chance _ | Rate _), Chance _ | Rate _, Open_chance _ -> 1

let hash = function
  | Chance q -> Rat.hash q
  | Open_chance n -> Rational_function.hash n.form
  | Rate { rate; _ } -> 1 + Rat.hash rate

let to_string = function
  | Chance q -> "chance " ^ Rat.to_string q
  | Open_chance n -> "chance " ^ Rational_function.to_string ~variable:n.parameter.name n.form
  | Rate { rate; _ } -> "rate " ^ Rat.to_string rate

let greatest = 1000
let power k = Q.of_bigint (Z.shift_left Z.one k)

(* Bounds of a number: the least and the greatest that it may be. *)
type bounds = { low : Rat.t; high : Rat.t }

let rounded bits { low; high } =
  let scale = power bits in
  let down q = Rat.div (Q.of_bigint (Rat.floor (Rat.mul q scale))) scale in
  { low = down low; high = Rat.neg (down (Rat.neg high)) }

(* exp(-y) for 0 < y <= 1/2. The terms of its series alternate and get smaller, so that it is between any two
   sums that follow each other. *)
let exponential bits y =
  let small = Rat.div Rat.one (power bits) in
  let rec add n term sum =
    let term = Rat.neg (Rat.div (Rat.mul term y) (Rat.of_int n)) in
    let next = Rat.add sum term in
    if Rat.compare (Rat.abs term) small < 0 then { low = Rat.min sum next; high = Rat.max sum next }
    else add (n + 1) term next
  in
  rounded bits (add 1 Rat.one Rat.one)

let square bits b = rounded bits { low = Rat.mul b.low b.low; high = Rat.mul b.high b.high }

(* By exp(-x) = exp(-x/2)^2. *)
let rec decay bits x =
  if Rat.compare x Rat.half <= 0 then exponential bits x else square bits (decay bits (Rat.mul x Rat.half))

let tolerance = Rat.div Rat.one (power 40)

(* Both ends of the range that is allowed grow with v. Where the simplest fraction between the outermost ends is
   between the innermost ones as well, it is that of the true range. *)
let rec simplest bits x =
  let e = decay bits x in
  let v = { low = Rat.sub Rat.one e.high; high = Rat.sub Rat.one e.low } in
  let slack v = Rat.mul tolerance (Rat.min v (Rat.sub Rat.one v)) in
  let below v = Rat.sub v (slack v) and above v = Rat.add v (slack v) in
  let finer () = simplest (2 * bits) x in
  if Rat.sign v.low <= 0 || Rat.sign e.low <= 0 then finer ()
  else
    let q = Scc_polyhedra.Fraction.simplest ~above:(Some (below v.low)) ~below:(Some (above v.high)) in
    if Rat.compare q (below v.high) > 0 && Rat.compare q (above v.low) < 0 then q else finer ()

let within ~step rate =
  let x = Rat.mul rate step in
  if Rat.sign x = 0 then Rat.zero else simplest 128 x

let shares ~step odds =
  let rates = List.filter_map (function Rate { rate; _ } -> Some rate | Chance _ | Open_chance _ -> None) odds in
  let all = List.fold_left Rat.add Rat.zero rates in
  let share rate alone =
    match rates with [ _ ] -> alone | _ -> Rat.mul (within ~step all) (Rat.div rate all)
  in
  List.map
    (function
      | Chance q -> q
      | Open_chance n -> n.value
      | Rate { rate; alone } -> if Rat.sign rate = 0 then Rat.zero else share rate alone)
    odds

let forms ~step odds =
  let form odds share =
    match odds with Open_chance n -> n.Open_number.form | Chance _ | Rate _ -> Rational_function.constant share
  in
  List.map2 form odds (shares ~step odds)
