open Scc_exact
module P = Pieces

type first = Reached of Timeline.moment | Lost of Timeline.moment | Passes

(* From the beginning of cell i on. *)
let rec scan (both : P.pair) i =
  if i = P.cells both.left then Passes
  else
    let f = P.holds both.left i and g = P.holds both.right i in
    let moment = { Timeline.offset = P.low both.left i; attained = P.is_point i } in
    if P.is_point i && g then Reached moment
    else if not f then Lost moment
    else if g then Reached moment
    else scan both (i + 1)

let entering ~f ~g =
  if P.is_constant f && P.is_constant g && P.holds f 0 && not (P.holds g 0) then Passes
  else scan (P.pair f g) 0

let from ~f ~g offset =
  let both = P.pair f g in
  let i = P.find both.left offset in
  let here = { Timeline.offset; attained = true } in
  if P.holds both.right i then Reached here
  else if not (P.holds both.left i) then Lost here
  else scan both (i + 1)

let constants f g ending =
  if P.is_constant f && P.is_constant g then Some (P.holds g 0 || (P.holds f 0 && ending)) else None

let inside ~f ~g ending =
  match constants f g ending with
  | Some v -> P.constant v
  | None ->
    let both = P.pair f g in
    (* [next] is the value for who enters what comes after cell i. *)
    let rec back i next acc =
      let f = P.holds both.left i and g = P.holds both.right i in
      let here = g || (f && next) in
      if i = 0 then P.of_pieces here acc
      else
        let enter = f && (g || next) in
        let c = i - 1 in
        let at = P.holds both.right c || (P.holds both.left c && enter) in
        back (c - 1) at ((P.low both.left c, at, here) :: acc)
    in
    back (P.cells both.left - 1) ending []

(* Whether who is at x has the moment before them by the bound at most. *)
let in_time bound x (m : Timeline.moment) =
  let c = Algebraic.compare (Algebraic.add_rat bound x) m.offset in
  if m.attained then c >= 0 else c > 0

(* An open cell on which g is still to come at the moment: the value at its beginning, and the cut after which
   it is in time. *)
let coming bound low high = function
  | None -> (false, [])
  | Some (m : Timeline.moment) ->
    let k = Algebraic.add_rat (Rat.neg bound) m.offset in
    if Algebraic.compare k low <= 0 then (true, [])
    else
      let beyond = match high with None -> false | Some h -> Algebraic.compare k h >= 0 in
      if beyond then (false, []) else (false, [ (k, m.attained, true) ])

let within ~bound ~limit ~f ~g arrival =
  let both = P.pair f g in
  let rec back i next acc =
    let f = P.holds both.left i and g = P.holds both.right i in
    let low = P.low both.left i in
    let high = match P.high both.left i with None -> limit | high -> high in
    let value, cut = if g then (true, []) else if f then coming bound low high next else (false, []) in
    let acc = cut @ acc in
    if i = 0 then P.of_pieces value acc
    else
      let enter =
        if not f then None else if g then Some { Timeline.offset = low; attained = false } else next
      in
      let c = i - 1 in
      let moment =
        if P.holds both.right c then Some { Timeline.offset = low; attained = true }
        else if P.holds both.left c then enter
        else None
      in
      let at = match moment with None -> false | Some m -> in_time bound low m in
      back (c - 1) moment ((low, at, value) :: acc)
  in
  back (P.cells both.left - 1) arrival []
