open Scc_data
open Scc_exact

let iter_next g s ~through ~passes f =
  if through s then begin
    Array.iter (fun t -> f t Rat.zero) (Timed_graph.edges g s);
    match Timed_graph.flow g s with
    | Lasts (d, targets) ->
      if passes (Positions.start s) then Array.iter (fun t -> f t d) targets
    | No_flow | Forever -> ()
  end

let iter_first g (p : Positions.position) ~passes f =
  if not (Positions.is_inside p) then f p.node Rat.zero
  else
    match Timed_graph.flow g p.node with
    | Lasts (d, targets) -> if passes p then Array.iter (fun t -> f t d) targets
    | No_flow | Forever -> ()

(* Without a time, the order does not matter. *)
let breadth_first (g : Timed_graph.t) positions ~through ~passes visit =
  let work = Worklist.create g.size in
  let enter s _ = Worklist.add work s in
  List.iter (fun p -> iter_first g p ~passes enter) positions;
  Worklist.run work (fun s ->
      visit s;
      iter_next g s ~through ~passes enter)

let in_order_of_time (g : Timed_graph.t) limit positions ~through ~passes visit =
  let seen = Bits.create g.size in
  let heap =
    Heap.create ~near:(fun (time, _) -> Rat.to_float time) ~compare:(fun (t, _) (u, _) -> Rat.compare t u)
  in
  let enter time s d =
    let time = Rat.add time d in
    if Algebraic.compare_rat limit time >= 0 && not (Bits.mem seen s) then Heap.add heap (time, s)
  in
  List.iter (fun p -> iter_first g p ~passes (enter Rat.zero)) positions;
  let rec go () =
    match Heap.take heap with
    | None -> ()
    | Some (time, s) ->
      if not (Bits.mem seen s) then begin
        Bits.add seen s;
        visit s;
        iter_next g s ~through ~passes (enter time)
      end;
      go ()
  in
  go ()

let visit g ?within positions ~through ~passes f =
  match within with
  | None -> breadth_first g positions ~through ~passes f
  | Some b ->
    let later acc (p : Positions.position) = if Algebraic.compare p.offset acc > 0 then p.offset else acc in
    let limit = Algebraic.add_rat b (List.fold_left later Algebraic.zero positions) in
    in_order_of_time g limit positions ~through ~passes f
