open Scc_exact

type t = { constant : Rat.t; coefficients : Rat.t array }

let make ~constant coefficients = { constant; coefficients = Array.copy coefficients }

let constant n c =
  Effort.spend n;
  { constant = c; coefficients = Array.make n Rat.zero }

let of_terms n ~constant terms =
  Effort.spend n;
  let coefficients = Array.make n Rat.zero in
  let add (i, a) =
    if i < 0 || i >= n then Scc_base.Bug.fail __POS__ "no such variable";
    coefficients.(i) <- Rat.add coefficients.(i) a
  in
  List.iter add terms;
  { constant; coefficients }

let variable n i = of_terms n ~constant:Rat.zero [ (i, Rat.one) ]
let dimension f = Array.length f.coefficients
let coefficient f i = f.coefficients.(i)
let is_constant f = Array.for_all (fun a -> Rat.sign a = 0) f.coefficients

let same_dimension f g =
  if dimension f <> dimension g then Scc_base.Bug.fail __POS__ "forms of different dimensions"

let combine op f g =
  same_dimension f g;
  Effort.spend (dimension f);
  { constant = op f.constant g.constant; coefficients = Array.map2 op f.coefficients g.coefficients }

let add = combine Rat.add
let sub = combine Rat.sub

let map f form =
  Effort.spend (dimension form);
  { constant = f form.constant; coefficients = Array.map f form.coefficients }

let neg = map Rat.neg
let scale k = map (Rat.mul k)

let eval f point =
  if Array.length point <> dimension f then Scc_base.Bug.fail __POS__ "a point of another dimension";
  let sum = ref f.constant in
  Array.iteri (fun i a -> if Rat.sign a <> 0 then sum := Rat.add !sum (Rat.mul a point.(i))) f.coefficients;
  !sum

let compose f ~dimension:n forms =
  if Array.length forms <> dimension f then Scc_base.Bug.fail __POS__ "a map of another dimension";
  let sum = ref (constant n f.constant) in
  Array.iteri (fun i a -> if Rat.sign a <> 0 then sum := add !sum (scale a forms.(i))) f.coefficients;
  !sum

let equal f g =
  dimension f = dimension g
  && Rat.equal f.constant g.constant
  && Array.for_all2 Rat.equal f.coefficients g.coefficients

let compare f g =
  let rec from i =
    if i >= dimension f then Rat.compare f.constant g.constant
    else
      let order = Rat.compare f.coefficients.(i) g.coefficients.(i) in
      if order <> 0 then order else from (i + 1)
  in
  let order = Int.compare (dimension f) (dimension g) in
  if order <> 0 then order else from 0

let hash f = Array.fold_left (fun h a -> (h * 31) + Rat.hash a) (Rat.hash f.constant) f.coefficients
