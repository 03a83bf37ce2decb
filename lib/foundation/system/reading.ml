let rec create_file path flags mode =
  match Unix.openfile path (O_CLOEXEC :: flags) mode with
  | file -> file
  | exception Unix.Unix_error (EINTR, _, _) ->
    (* It is a pipe that nobody else has opened. *)
    if Interruption.heard () then Interruption.break_off ();
    create_file path flags mode

let open_file path = create_file path [ O_RDONLY ] 0

let rec some file bytes from most =
  Interruption.check ();
  match Unix.read file bytes from most with
  | n -> n
  | exception Unix.Unix_error (EINTR, _, _) -> some file bytes from most
  | exception Unix.Unix_error ((EAGAIN | EWOULDBLOCK), _, _) ->
    (match Unix.select [ file ] [] [] (-1.) with _ -> () | exception Unix.Unix_error (EINTR, _, _) -> ());
    some file bytes from most

exception Failed of string

let input bytes from most =
  match some Unix.stdin bytes from most with
  | n -> n
  | exception Unix.Unix_error (e, _, _) -> raise (Failed (Unix.error_message e))
