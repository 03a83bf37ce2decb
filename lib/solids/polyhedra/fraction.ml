open Scc_exact

let one_more z = Q.of_bigint (Z.succ z)

(* In 0 <= low < high: the path to it in the tree of M. Stern and A. Brocot, by continued fractions. *)
let rec between low high =
  let next = one_more (Rat.floor low) in
  if Rat.compare next high < 0 then next
  else
    (* no integer is inside: the whole part, and the reciprocal of the rest; high may be the next integer itself *)
    let whole = Q.of_bigint (Rat.floor low) in
    let rest = Rat.sub low whole in
    let inverse = Rat.div Rat.one (Rat.sub high whole) in
    let found =
      if Rat.sign rest = 0 then one_more (Rat.floor inverse) else between inverse (Rat.div Rat.one rest)
    in
    Rat.add whole (Rat.div Rat.one found)

let simplest ~above ~below =
  match (above, below) with
  | None, None -> Rat.zero
  | Some low, None -> if Rat.sign low < 0 then Rat.zero else one_more (Rat.floor low)
  | None, Some high -> if Rat.sign high > 0 then Rat.zero else Rat.neg (one_more (Rat.floor (Rat.neg high)))
  | Some low, Some high ->
    if Rat.compare low high >= 0 then Scc_base.Bug.fail __POS__ "an empty range";
    if Rat.sign low >= 0 then between low high
    else if Rat.sign high > 0 then Rat.zero
    else Rat.neg (between (Rat.neg high) (Rat.neg low))
