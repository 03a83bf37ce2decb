open Scc_data
open Scc_exact

let hide g =
  Graph.map_labels g (fun l -> if Option.is_some (Label.passing l) then Graph.tau else l)

let without_durations g =
  Graph.map_labels g (fun l -> if Option.is_some (Label.passing l) then "time" else l)

(* How a state at which nothing but time can pass goes on. *)
type way = Not_looked_at | Under_way | Ends of int * Rat.t  (* where, after how long *) | For_ever

let passings (g : Graph.t) = Array.map Label.passing g.labels

(* The one thing that can happen in the state, if it is a passing of time. *)
let only_passing (g : Graph.t) passings s =
  let e = Int_array.get g.first s in
  if Graph.known g s && Int_array.get g.first (s + 1) = e + 1 then
    Option.map (fun p -> (p, Int_array.get g.target e)) passings.(Int_array.get g.label e)
  else None

(* From [s], the way to a state where something else can happen, for all states on it at once. *)
let follow g passings ways s =
  let rec walk s above =
    match (ways.(s), only_passing g passings s) with
    | (Under_way | For_ever), _ -> (For_ever, above)
    | Ends (last, d), _ -> (Ends (last, d), above)
    | Not_looked_at, None -> (Ends (s, Rat.zero), above)
    | Not_looked_at, Some (Label.Forever, _) ->
      ways.(s) <- For_ever;
      (For_ever, above)
    | Not_looked_at, Some (Label.For d, next) ->
      ways.(s) <- Under_way;
      walk next ((s, d) :: above)
  in
  let back way (s, d) =
    let way = match way with Ends (last, rest) -> Ends (last, Rat.add d rest) | w -> w in
    ways.(s) <- way;
    way
  in
  let last, above = walk s [] in
  ignore (List.fold_left back last above)

(* One round, and whether it changed anything. *)
let merge_once (g : Graph.t) =
  let passings = passings g in
  let ways = Array.make g.size Not_looked_at in
  for s = 0 to g.size - 1 do
    match (ways.(s), only_passing g passings s) with
    | Not_looked_at, Some _ -> follow g passings ways s
    | _ -> ()
  done;
  let changed = ref false in
  let b = Graph.builder () in
  let numbers = Array.map (Graph.intern b) g.labels in
  let time p = Graph.intern b (Label.of_passing p) in
  (* where time passes for ever: a state of its own, after the others *)
  let rest = g.size in
  let for_ever source = Graph.add b ~source ~label:(time Forever) ~target:rest in
  let add_edge s label target =
    match passings.(label) with
    | None -> Graph.add b ~source:s ~label:numbers.(label) ~target
    | Some Forever -> for_ever s
    | Some (For d) -> (
        match ways.(target) with
        | For_ever ->
          changed := true;
          for_ever s
        | Ends (last, more) ->
          changed := true;
          Graph.add b ~source:s ~label:(time (For (Rat.add d more))) ~target:last
        | Not_looked_at | Under_way -> Graph.add b ~source:s ~label:(time (For d)) ~target)
  in
  for s = 0 to g.size - 1 do
    match ways.(s) with
    | For_ever -> for_ever s
    | _ -> Graph.iter g s (add_edge s)
  done;
  for_ever rest;
  let unknown s = s < g.size && not (Graph.known g s) in
  let merged = Graph.finish b ~size:(g.size + 1) ~initial:g.initial ~unknown in
  (Graph.reachable merged, !changed)

(* Passings that have become the same may leave a state where nothing else can happen. Every round but the first
   is due to fewer edges. *)
let rec merge g =
  let merged, changed = merge_once g in
  if changed then merge merged else merged

let deterministic (g : Graph.t) =
  let is_time = Array.map (fun l -> Option.is_some (Label.passing l)) g.labels in
  let one s =
    let n = ref 0 in
    Graph.iter g s (fun label _ -> if is_time.(label) then incr n);
    !n <= 1
  in
  let rec all s = s = g.size || (one s && all (s + 1)) in
  all 0
