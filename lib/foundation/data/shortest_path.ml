let find ~successors ~from ~goal =
  let reached : (int, _) Hashtbl.t = Hashtbl.create 64 in
  let queue = Queue.create () in
  let rec back v acc =
    match Hashtbl.find reached v with
    | None -> acc
    | Some (u, step) -> back u ((u, step) :: acc)
  in
  let enter v by =
    if not (Hashtbl.mem reached v) then begin
      Hashtbl.add reached v by;
      Queue.push v queue
    end
  in
  enter from None;
  let rec go () =
    match Queue.take_opt queue with
    | None -> None
    | Some v when goal v -> Some (back v [])
    | Some v ->
      List.iter (fun (w, step) -> enter w (Some (v, step))) (successors v);
      go ()
  in
  go ()
