type t = { next : unit -> string option; keep : string -> unit }

let none = { next = (fun () -> None); keep = ignore }

let in_memory blocks =
  let left = ref blocks and kept = ref (List.rev blocks) in
  let next () =
    match !left with
    | [] -> None
    | block :: rest ->
      left := rest;
      Some block
  in
  ({ next; keep = (fun block -> kept := block :: !kept) }, fun () -> List.rev !kept)
