open Scc_codec
open Progress

type t = {
  fresh : int;
  transitions : int;
  too_long : int;
  too_deep : int;
  keep : bool;
  met : event option array;
  doubts : event option array;
  faults : (string * int) list;
  ends : string list;
}

let put_event b (e : event) =
  List.iter (Packed.put_nat b) [ e.rank; Bool.to_int e.ahead; e.choice; e.owner; e.id ]

let read_event s : event =
  let rank = Packed.nat s in
  let ahead = read_bool s in
  let choice = Packed.nat s in
  let owner = Packed.nat s in
  { rank; ahead; choice; owner; id = Packed.nat s }

let put b t =
  List.iter (Packed.put_nat b) [ t.fresh; t.transitions; t.too_long; t.too_deep ];
  put_bool b t.keep;
  let events = Packed.put_list b (fun b -> put_option b put_event) in
  events (Array.to_list t.met);
  events (Array.to_list t.doubts);
  put_texts b (List.map fst t.faults);
  List.iter (fun (_, rank) -> Packed.put_nat b rank) t.faults;
  put_texts b t.ends

let read s =
  let fresh = Packed.nat s in
  let transitions = Packed.nat s in
  let too_long = Packed.nat s in
  let too_deep = Packed.nat s in
  let keep = read_bool s in
  let events () = Array.of_list (Packed.list s (fun s -> read_option s read_event)) in
  let met = events () in
  let doubts = events () in
  let faults = List.map (fun text -> (text, Packed.nat s)) (Packed.list s Packed.text) in
  { fresh; transitions; too_long; too_deep; keep; met; doubts; faults; ends = Packed.list s Packed.text }

(* {1 All of them} *)

let sum f all = Array.fold_left (fun n t -> n + f t) 0 all
let first f all goal = Array.fold_left (fun best t -> earlier best (f t).(goal)) None all

let merge all =
  let goals = Array.length all.(0).met in
  let texts f = List.concat_map f (Array.to_list all) in
  {
    fresh = sum (fun t -> t.fresh) all;
    transitions = sum (fun t -> t.transitions) all;
    too_long = sum (fun t -> t.too_long) all;
    too_deep = sum (fun t -> t.too_deep) all;
    keep = Array.exists (fun t -> t.keep) all;
    met = Array.init goals (first (fun t -> t.met) all);
    doubts = Array.init goals (first (fun t -> t.doubts) all);
    faults = texts (fun t -> t.faults);
    ends = texts (fun t -> t.ends);
  }
