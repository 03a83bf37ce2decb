open Scc_exact
open Scc_ctl
open Scc_codec
open Progress

type event = { moment : Timeline.moment; turn : int; place : int; owner : int; id : int }

type t = {
  found : int;
  ranked : int;
  transitions : int;
  too_long : int;
  opened : int option;
  met : event option array;
  next : (Rat.t * int) option;
  faults : (string * int) list;
  ends : string list;
}

let compare_events a b =
  Timeline.compare_moment a.moment b.moment <?> fun () ->
    Int.compare a.turn b.turn <?> fun () -> Int.compare a.place b.place

let earlier a b = Option.merge (fun a b -> if compare_events b a < 0 then b else a) a b

(* {1 As bytes} *)

let put_event b e =
  Moments.put b e.moment;
  List.iter (Packed.put_nat b) [ e.turn; e.place; e.owner; e.id ]

let read_event s =
  let moment = Moments.read s in
  let turn = Packed.nat s in
  let place = Packed.nat s in
  let owner = Packed.nat s in
  { moment; turn; place; owner; id = Packed.nat s }

let put_next b (time, turn) =
  Packed.put_rational b time;
  Packed.put_nat b turn

let read_next s =
  let time = Packed.rational s in
  (time, Packed.nat s)

let put b t =
  List.iter (Packed.put_nat b) [ t.found; t.ranked; t.transitions; t.too_long ];
  put_option b Packed.put_nat t.opened;
  Packed.put_list b (fun b -> put_option b put_event) (Array.to_list t.met);
  put_option b put_next t.next;
  put_texts b (List.map fst t.faults);
  List.iter (fun (_, turn) -> Packed.put_nat b turn) t.faults;
  put_texts b t.ends

let read s =
  let found = Packed.nat s in
  let ranked = Packed.nat s in
  let transitions = Packed.nat s in
  let too_long = Packed.nat s in
  let opened = read_option s Packed.nat in
  let met = Array.of_list (Packed.list s (fun s -> read_option s read_event)) in
  let next = read_option s read_next in
  let faults = List.map (fun text -> (text, Packed.nat s)) (Packed.list s Packed.text) in
  { found; ranked; transitions; too_long; opened; met; next; faults; ends = Packed.list s Packed.text }

(* {1 All of them} *)

let sooner (a, m) (b, n) =
  let c = Rat.compare a b in
  if c < 0 then (a, m) else if c > 0 then (b, n) else (a, Int.min m n)

let merge all =
  let sum f = Array.fold_left (fun n t -> n + f t) 0 all in
  let least merge f = Array.fold_left (fun best t -> Option.merge merge best (f t)) None all in
  let texts f = List.concat_map f (Array.to_list all) in
  let met goal = Array.fold_left (fun best t -> earlier best t.met.(goal)) None all in
  {
    found = sum (fun t -> t.found);
    ranked = sum (fun t -> t.ranked);
    transitions = sum (fun t -> t.transitions);
    too_long = sum (fun t -> t.too_long);
    opened = least Int.min (fun t -> t.opened);
    met = Array.init (Array.length all.(0).met) met;
    next = least sooner (fun t -> t.next);
    faults = texts (fun t -> t.faults);
    ends = texts (fun t -> t.ends);
  }
