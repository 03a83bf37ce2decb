open Scc_exact

type t = { id : int; time : Rat.t; first : Clock.first option; before : int; place : int }

(* Of what is found with one state: new states come first, in order, then known ones that become earlier, and last
   what holds after it. *)
let phase = 1 lsl 29

let place_of ~is_first choice =
  if choice >= phase then Failure.lost "a limit of resources: a state with more than 2^29 transitions";
  if is_first then choice else phase + choice

let place_after = 2 * phase
let is_new t = Option.is_some t.first
let compare a b = Int.compare a.before b.before <?> fun () -> Int.compare a.place b.place

let all part clock =
  let one (id, (first : Clock.first option)) =
    let way = Part.way part id in
    let is_first = match first with Some f -> f.before = way.before && f.choice = way.choice | None -> false in
    if Option.is_none first then Part.look_again part id;
    let time = Clock.time clock (Clock.arrival clock id) in
    { id; time; first; before = way.before; place = place_of ~is_first way.choice }
  in
  let all = Array.of_list (List.map one (Clock.touched clock)) in
  Array.sort compare all;
  Clock.close clock;
  all
