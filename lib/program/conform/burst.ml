open Scc_exact
open Scc_calculus
open Scc_semantics

type event = { item : int; leaves : int list; before : State.t; time : Rat.t; order : int }

let met (h : State.t) ~firsts ~time ~item ~order =
  let processes = List.filter_map (State.home h) (List.sort_uniq Int.compare firsts) in
  {
    item; time; order; leaves = List.concat_map State.members processes;
    before = State.make ~processes ~step:h.step ~time:h.time;
  }

let equal a b = a.item = b.item && Rat.equal a.time b.time && State.equal a.before b.before

(* Where its bodies would be at that time, had it not happened. What spins is not taken back. *)
let without against e time =
  let model = Against.model against in
  let d = Rat.sub time e.time in
  let go p = if Rat.sign d < 0 && Turn.spinning p then p else Turn.pass model d p in
  State.mapi (fun _ -> go) e.before

(* A way to read a body: which of its events have happened, by their orders, and how far off that is. *)
type reading = { happened : (int * bool) list; deviation : Against.deviation }

(* Of a body that takes part in these, in their order. *)
let readings against ~now ~time events (b : Recorded.body) =
  let fits s = match Against.body against s b with [], deviation -> Some deviation | _ :: _, _ -> None in
  let reading happened = Option.map (fun deviation -> { happened; deviation }) in
  let up_to (e : event) =
    let happened = List.map (fun (o : event) -> (o.order, o.order < e.order)) events in
    List.filter_map (fun s -> reading happened (fits s)) [ e.before; without against e time ]
  in
  let all = List.map (fun (e : event) -> (e.order, true)) events in
  Option.to_list (reading all (fits now)) @ List.concat_map up_to events

(* One reading of each body, so that each event has happened to all bodies of it or to none. *)
let rec agreeing known deviation = function
  | [] -> Some deviation
  | readings :: rest ->
    let try_ r =
      let against (order, happened) =
        match List.assoc_opt order known with Some h -> h <> happened | None -> false
      in
      if List.exists against r.happened then None
      else agreeing (r.happened @ known) (Against.later deviation r.deviation) rest
    in
    List.find_map try_ readings

let differences against ~now ~time events bodies step =
  let in_order = List.sort (fun a b -> Int.compare a.order b.order) events in
  let events_of (b : Recorded.body) =
    match Against.leaf against b.name with
    | Some l -> List.filter (fun e -> List.mem l e.leaves) in_order
    | None -> []
  in
  let known = List.map (fun b -> (b, events_of b)) bodies in
  let amid, apart = List.partition (fun (_, events) -> events <> []) known in
  let found, deviation = Against.differences against now (List.map fst apart) step in
  let read = List.map (fun (b, events) -> readings against ~now ~time events b) amid in
  (* Those that can be read in one way only decide for the others. *)
  let read = List.sort (fun a b -> List.compare_lengths a b) read in
  match agreeing [] deviation read with
  | Some deviation -> (found, deviation)
  | None ->
    let after = List.concat_map (fun (b, _) -> fst (Against.body against now b)) amid in
    (after @ found, deviation)
