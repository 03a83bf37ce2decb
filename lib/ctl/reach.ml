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
  let seen = Bytes.make g.size '\000' and queue = Queue.create () in
  let enter s _ =
    if Char.equal (Bytes.get seen s) '\000' then begin
      Bytes.set seen s '\001';
      Queue.push s queue
    end
  in
  List.iter (fun p -> iter_first g p ~passes enter) positions;
  while not (Queue.is_empty queue) do
    let s = Queue.pop queue in
    visit s;
    iter_next g s ~through ~passes enter
  done

let in_order_of_time (g : Timed_graph.t) limit positions ~through ~passes visit =
  let seen = Bytes.make g.size '\000' in
  let heap = Heap.create ~compare:Rat.compare Rat.zero in
  let enter time s d =
    let time = Rat.add time d in
    if Algebraic.compare_rat limit time >= 0 && Char.equal (Bytes.get seen s) '\000' then
      Heap.push heap time s
  in
  List.iter (fun p -> iter_first g p ~passes (enter Rat.zero)) positions;
  let rec go () =
    match Heap.pop heap with
    | None -> ()
    | Some (time, s) ->
      if Char.equal (Bytes.get seen s) '\000' then begin
        Bytes.set seen s '\001';
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
