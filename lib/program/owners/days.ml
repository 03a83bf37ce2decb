open Scc_data
open Scc_exact
module Times = Map.Make (Rat)

type t = { clock : Clock.t; mutable days : int Growable.t Times.t }

let make clock = { clock; days = Times.empty }
let is_of d time id = Rat.equal (Clock.time d.clock (Clock.arrival d.clock id)) time

let put d time id =
  let day =
    match Times.find_opt time d.days with
    | Some day -> day
    | None ->
      let day = Growable.create () in
      d.days <- Times.add time day d.days;
      day
  in
  Growable.push day id

let of_day d time day =
  List.filter (is_of d time) (List.init (Growable.length day) (Growable.get day))

let take d time =
  let day = Option.value (Times.find_opt time d.days) ~default:(Growable.create ()) in
  d.days <- Times.remove time d.days;
  Array.of_list (of_day d time day)

let first d ~none =
  let least_turn (time, day) =
    let rec from k =
      if k = Growable.length day then none
      else
        let id = Growable.get day k in
        if is_of d time id then Clock.turn d.clock id else from (k + 1)
    in
    (time, from 0)
  in
  Option.map least_turn (Times.min_binding_opt d.days)

let iter d each = Times.iter (fun time day -> List.iter each (of_day d time day)) d.days
