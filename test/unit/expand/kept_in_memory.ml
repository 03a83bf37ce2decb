(* A log in memory that begins with some blocks, and a function that returns all its blocks so far, in order. *)
let log blocks =
  let left = ref blocks and kept = ref (List.rev blocks) in
  let next () =
    match !left with
    | [] -> None
    | block :: rest ->
      left := rest;
      Some block
  in
  ({ Scc_parallel.Log.next; keep = (fun block -> kept := block :: !kept) }, fun () -> List.rev !kept)
