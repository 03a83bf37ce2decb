open Scc_exact
open Scc_calculus
open Property

type case = { rate : Vec.t; least : Rat.t; greatest : Rat.t }

(* More cases than this are not told apart. *)
let most_cases = 64

let constant b = { rate = Vec.zero; least = b; greatest = b }
let ranges greatest = Some [ { rate = Vec.zero; least = Rat.zero; greatest = Rat.of_int greatest } ]

let scaled k c =
  let ends = (Rat.mul k c.least, Rat.mul k c.greatest) in
  let least, greatest = if Rat.sign k < 0 then (snd ends, fst ends) else ends in
  { rate = Vec.scale k c.rate; least; greatest }

let sum c d =
  { rate = Vec.add c.rate d.rate; least = Rat.add c.least d.least; greatest = Rat.add c.greatest d.greatest }

(* The one number that it is in all cases, if so. *)
let single = function
  | [ c ] when Vec.is_zero c.rate && Rat.equal c.least c.greatest -> Some c.least
  | _ -> None

let few cases = if List.compare_length_with cases most_cases > 0 then None else Some cases

(* How many bonds, leaves and processes there may be. *)
let bounded (m : Model.t) (q : quantity) =
  match q with
  | Processes -> ranges (Array.length m.leaves)
  | Size _ -> ranges (Model.part_count m)
  | Bonds (_, Some _) -> ranges 1
  | Bonds (_, None) ->
    let n = Array.length m.leaves in
    ranges (n * (n - 1) / 2)
  | Time | Position _ | Velocity _ | Speed2 _ | Spin _ | Spin2 _ | Distance2 _ | Momentum _ | Angular _ | Energy
  | Parameter _ -> None

let rec cases m ~variable = function
  | Const b -> Some [ constant b ]
  | Quantity q -> (
      match variable q with
      | Some rate -> Some [ { (constant Rat.zero) with rate } ]
      | None -> bounded m q)
  | Count ps -> ranges (List.length ps)
  | Neg n -> Option.map (List.map (scaled (Rat.neg Rat.one))) (cases m ~variable n)
  | Add (a, b) -> both m ~variable (fun xs ys -> few (List.concat_map (fun x -> List.map (sum x) ys) xs)) a b
  | Sub (a, b) -> cases m ~variable (Add (a, Neg b))
  | Mul (a, b) ->
    let product xs ys =
      match (single xs, single ys) with
      | Some k, _ -> Some (List.map (scaled k) ys)
      | None, Some k -> Some (List.map (scaled k) xs)
      | None, None -> None
    in
    both m ~variable product a b
  | Div (a, b) ->
    let quotient xs ys =
      match single ys with
      | Some k when Rat.sign k <> 0 -> Some (List.map (scaled (Rat.div Rat.one k)) xs)
      | Some _ | None -> None
    in
    both m ~variable quotient a b
  | If (_, a, b) -> both m ~variable (fun xs ys -> few (xs @ ys)) a b

and both m ~variable f a b =
  match (cases m ~variable a, cases m ~variable b) with
  | Some xs, Some ys -> f xs ys
  | None, _ | _, None -> None

let first_of (v : Vec.t) = List.find (fun c -> Rat.sign c <> 0) [ v.x; v.y; v.z ]

let zeros c =
  if Vec.is_zero c.rate then None
  else
    let unit = first_of c.rate in
    let at b = Rat.div (Rat.neg b) unit in
    let one = at c.least and two = at c.greatest in
    Some (Vec.scale (Rat.div Rat.one unit) c.rate, (Rat.min one two, Rat.max one two))

let rec conditions n =
  let { Parts.numbers; predicates } = Parts.of_num n in
  predicates @ List.concat_map conditions numbers

let rec values = function
  | Quantity q -> [ q ]
  | n -> List.concat_map values (Parts.of_num n).numbers
