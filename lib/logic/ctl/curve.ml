open Scc_exact
open Scc_data
open Decisions

let start q w s = next q w (place w s Rat.zero)

let first_of q : Timeline.moment = { offset = Algebraic.of_rat (Rat.max Rat.zero q.bound.low); attained = true }

(* Where runs may come back to a node in no time, all places are looked at one by one. *)
let arrivals ~most q w starts =
  match Layers.until ~most q w starts with
  | Some layers -> Layers.arrivals q w layers
  | None ->
    let places = (build ~choices:(choices q w) starts).places in
    let after elapsed (m : Timeline.moment) = { m with offset = Algebraic.add_rat elapsed m.offset } in
    let of_place (p : place) = List.map (after (Option.get p.elapsed)) (meetings q w p) in
    let all = List.concat_map of_place (List.init (Growable.length places) (Growable.get places)) in
    List.sort_uniq Timeline.compare_moment all

let moments ~most q s =
  let first = first_of q and w = window q in
  if is_open w then None
  else
    let after m = Timeline.compare_moment first m < 0 in
    Some (first :: List.filter after (arrivals ~most q w [ start q w s ]))

(* Between a moment and the next one at another time. *)
let rec between (m : Timeline.moment) later ~high =
  match later with
  | (next : Timeline.moment) :: rest ->
    if Algebraic.equal m.offset next.offset then between m rest ~high
    else Some (Pieces.inside m.offset (Some next.offset))
  | [] when Algebraic.compare_rat m.offset high < 0 -> Some (Pieces.inside m.offset (Some (Algebraic.of_rat high)))
  | [] -> None

(* All rational moments that are not attained are followed after one time, so that their layers are common. *)
let horizons moments ~high =
  let rec with_next done_ = function
    | [] -> List.rev done_
    | m :: rest -> with_next ((m, between m rest ~high) :: done_) rest
  in
  let all = with_next [] moments in
  let gap (m : Timeline.moment) next =
    match (Algebraic.to_rat m.offset, next) with Some x, Some y -> Some (Rat.sub y x) | _ -> None
  in
  let shortest =
    List.fold_left
      (fun least (m, next) ->
         match (gap m next, least) with
         | Some g, Some l -> Some (Rat.min g l)
         | Some g, None -> Some g
         | None, _ -> least)
      None all
  in
  let horizon ((m : Timeline.moment), next) =
    match (Algebraic.to_rat m.offset, next) with
    | Some x, _ when m.attained -> if Rat.compare x high <= 0 then Some (m, x) else None
    | Some x, Some _ -> Some (m, Rat.add x (Option.get shortest))
    | None, Some after -> Some (m, after)
    | _, None -> None
  in
  List.filter_map horizon all

let values q effort s times =
  if Rat.sign q.bound.low <= 0 then
    let w = window q and high = Option.get q.bound.high in
    let starts = List.map (fun time -> next q w (place w s (Rat.sub high time))) times in
    List.map (Likelihood.within q effort w starts) starts
  else
    let one time =
      let q = { q with bound = { q.bound with high = Some time } } in
      let w = window q in
      Likelihood.within q effort w [ start q w s ] (start q w s)
    in
    List.map one times
