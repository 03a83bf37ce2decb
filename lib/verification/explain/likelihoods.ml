open Scc_exact
open Scc_chance

(* Below a number, and above it, in so many decimals. *)
let digits = 6

let scale = Rat.make (Z.pow (Z.of_int 10) digits) Z.one
let below = Decimal.rounded_down ~places:digits
let above = Decimal.rounded_up ~places:digits

let longest = 24

(* What is hardly more than 0 is not said to be 0, nor what is hardly less than 1 to be 1. *)
let rounded x =
  let plain () = "about " ^ Decimal.padded ~places:digits x in
  let near a b = Rat.compare (Rat.mul (Rat.abs (Rat.sub a b)) scale) Rat.one < 0 in
  if near x Rat.zero then "about " ^ Decimal.significant ~digits:4 x
  else if near x Rat.one then if Rat.compare x Rat.one < 0 then "more than " ^ below x else plain ()
  else plain ()

let number x =
  let text = Rat.to_string x in
  if String.length text > 2 * longest then rounded x
  else if String.length text > longest then Printf.sprintf "%s (%s)" text (rounded x)
  else text

let in_full (m : Scc_ctl.Eval.measured) =
  match (Answer.lower m.least, Answer.upper m.most) with
  | Some x, Some y when Rat.equal x y ->
    let text = Rat.to_string x in
    if String.length text > 2 * longest then Some text else None
  | Some x, Some y -> Some (Printf.sprintf "in [%s, %s]" (Rat.to_string x) (Rat.to_string y))
  | Some x, None -> Some ("at least " ^ Rat.to_string x)
  | None, _ -> None

let between low high =
  match (low, high) with
  | Some x, Some y when Rat.equal x y -> number x
  | Some x, Some y -> Printf.sprintf "in [%s, %s]" (below x) (above y)
  | Some x, None -> Printf.sprintf "at least %s" (below x)
  | None, _ -> "infinite"

let measured (m : Scc_ctl.Eval.measured) = between (Answer.lower m.least) (Answer.upper m.most)

let side : Scc_property.Property.side -> string = function Least -> "least" | Greatest -> "greatest"
let known s m = Printf.sprintf "the %s probability is %s" (side s) (measured m)

let is_exact (m : Scc_ctl.Eval.measured) =
  match (m.least, m.most) with
  | Exact x, Exact y -> Rat.equal x y
  | Infinite, Infinite -> true
  | (Exact _ | Within _ | At_least _ | Infinite), _ -> false

let equal (a : Scc_ctl.Eval.measured) (b : Scc_ctl.Eval.measured) =
  let same end_ x y = Option.equal Rat.equal (end_ x) (end_ y) in
  let same x y = same Answer.lower x y && same Answer.upper x y in
  same a.least b.least && same a.most b.most

let values = function
  | (_, first) :: (_ :: _ as rest) when List.for_all (fun (_, m) -> equal first m) rest -> measured first
  | list -> String.concat ", " (List.map (fun (s, m) -> Printf.sprintf "%s %s" (side s) (measured m)) list)

let of_run chance =
  if Rat.equal chance Rat.one then "the choices that attain it lead to this run:"
  else Printf.sprintf "the choices that attain it lead to this run, among others, with the probability %s:"
      (number chance)

let of_sides ~is_chain sides find =
  match sides with
  | first :: (_ :: _ as others) when is_chain () ->
    let found = find first in
    (first, found) :: List.map (fun s -> (s, found)) others
  | _ -> List.map (fun s -> (s, find s)) sides
