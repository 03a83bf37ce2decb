open Scc_exact
open Scc_calculus

type mark = { at : Rat.t; label : string; exact : string }

let most = Rat.of_int 8
let longest = 7

let ten_to n =
  let power = Q.of_bigint (Z.pow (Z.of_int 10) (abs n)) in
  if n >= 0 then power else Rat.div Rat.one power

(* The least step that leaves at most eight parts. *)
let step width =
  let magnitude = Decimal.order_of_magnitude width in
  let steps n = List.map (fun k -> Rat.mul (Rat.of_int k) (ten_to n)) [ 1; 2; 5 ] in
  let few s = Rat.compare (Rat.div width s) most <= 0 in
  List.find few (List.concat_map steps [ magnitude - 1; magnitude; magnitude + 1 ])

let multiples step high first =
  let rec go found x = if Rat.compare x high > 0 then List.rev found else go (x :: found) (Rat.add x step) in
  go [] first

let marks (r : Ranges.range) =
  let low = r.low.value and high = r.high.value in
  let step = step (Rat.sub high low) in
  let first = Rat.mul step (Rat.neg (Q.of_bigint (Rat.floor (Rat.neg (Rat.div low step))))) in
  let labels = List.map (fun at -> (at, Decimal.exact at)) (multiples step high first) in
  let short = function
    | _, Some text -> String.length text <= longest
    | _, None -> false
  in
  if List.for_all short labels then
    List.map (fun (at, label) -> { at; label = Option.get label; exact = Rat.to_string at }) labels
  else
    [
      { at = low; label = "low"; exact = Rat.to_string low };
      { at = high; label = "high"; exact = Rat.to_string high };
    ]
