open Scc_base
open Scc_system

exception Failed of Diag.t

(* [path] is what the user knows the file by. *)
let fail path message =
  raise
    (Failed (Diag.error Code.cannot_write (Span.of_file path) "cannot write: %s" message))

let failing path f =
  try f () with
  | Sys_error message -> fail path (Os_error.reason path message)
  | Unix.Unix_error (e, _, _) -> fail path (Unix.error_message e)

(* Where the bytes go first, and what is done with them when all are there. *)
type place =
  | Directly of string  (** what is no regular file, or is in a folder in which no file can be made *)
  | Beside of { temporary : string; target : string; shared : bool  (** by several names *) }

type opened = { path : string; place : place; out : out_channel }

(* The file that a path leads to through links, whether or not it is there. *)
let rec target ?(links = 0) path =
  match Unix.readlink path with
  | exception Unix.Unix_error _ -> path
  | _ when links > 40 -> path
  | next ->
    let next = if Filename.is_relative next then Filename.concat (Filename.dirname path) next else next in
    target ~links:(links + 1) next

(* A file that nobody else has, next to the target so that it can take its place. *)
let rec make_temporary ?(attempt = 0) target ~mode =
  let folder = Filename.dirname target and name = Filename.basename target in
  let temporary = Filename.concat folder (Printf.sprintf ".%s.%d-%d.part" name (Unix.getpid ()) attempt) in
  match Reading.create_file temporary [ O_WRONLY; O_CREAT; O_EXCL ] mode with
  | file -> (temporary, file)
  | exception Unix.Unix_error (EEXIST, _, _) when attempt < 100 ->
    make_temporary ~attempt:(attempt + 1) target ~mode

let directly path =
  let file = Reading.create_file path [ O_WRONLY; O_CREAT; O_TRUNC ] 0o666 in
  (Directly path, file)

(* Who may read and write it stays as it was, as far as that is for us to say. *)
let like_before file (before : Unix.stats) =
  (try Unix.fchown file before.st_uid before.st_gid with Unix.Unix_error _ -> ());
  try Unix.fchmod file before.st_perm with Unix.Unix_error _ -> ()

let beside target ~mode ~shared =
  let temporary, file = make_temporary target ~mode in
  (Beside { temporary; target; shared }, file)

let place path =
  let target = target path in
  match Unix.stat target with
  | exception Unix.Unix_error (ENOENT, _, _) -> beside target ~mode:0o666 ~shared:false
  | { st_kind = S_REG; _ } as before -> (
      (* It has to be one that may be written to, though it is not written to until all is there. *)
      Unix.access target [ W_OK ];
      match beside target ~mode:0o600 ~shared:(before.st_nlink > 1) with
      | exception Unix.Unix_error ((EACCES | EPERM | EROFS), _, _) -> directly target
      | place, file ->
        like_before file before;
        (place, file))
  | _ -> directly path

let start path =
  failing path (fun () ->
      let place, file = place path in
      let out = Unix.out_channel_of_descr file in
      set_binary_mode_out out true;
      { path; place; out })

let put o text = failing o.path (fun () -> output_string o.out text)

(* What cannot be kept on its way (a pipe, a device) is written all the same. *)
let sync o = try Unix.fsync (Unix.descr_of_out_channel o.out) with Unix.Unix_error _ -> ()

let finish o =
  failing o.path (fun () ->
      flush o.out;
      sync o;
      close_out o.out)

let drop o =
  close_out_noerr o.out;
  match o.place with
  | Directly _ -> ()
  | Beside { temporary; _ } -> ( try Sys.remove temporary with Sys_error _ -> ())

let contents path =
  let file = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in_noerr file)
    (fun () -> really_input_string file (in_channel_length file))

let copy_into target temporary =
  let bytes = contents temporary in
  let file = Reading.create_file target [ O_WRONLY; O_TRUNC ] 0o666 in
  let out = Unix.out_channel_of_descr file in
  set_binary_mode_out out true;
  Fun.protect ~finally:(fun () -> close_out_noerr out) (fun () ->
      output_string out bytes;
      flush out)

let settle o =
  match o.place with
  | Directly _ -> ()
  | Beside { temporary; target; shared } ->
    failing o.path (fun () ->
        (* To rename over one of the names of a file would part it from the others. *)
        if shared then begin
          copy_into target temporary;
          Sys.remove temporary
        end
        else Sys.rename temporary target)

(* A channel that could not write some bytes tries again when it is closed. *)
let keep o ~complete =
  close_out_noerr o.out;
  match o.place with
  | Directly _ -> ()
  | Beside { temporary; _ } ->
    failing o.path (fun () -> Unix.truncate temporary complete);
    settle o

let with_pieces path f =
  let complete = ref 0 and pieces = ref 0 in
  let put_piece o text =
    put o text;
    failing path (fun () -> flush o.out);
    complete := pos_out o.out;
    incr pieces
  in
  let kept (d : Diag.t) = { d with hint = Some "what was complete before that is in the file" } in
  match start path with
  | exception Failed d -> Error d
  | o -> (
      match
        let result = f (put_piece o) in
        finish o;
        settle o;
        result
      with
      | result -> Ok result
      | exception Failed d when !pieces > 1 -> (
          match keep o ~complete:!complete with () -> Error (kept d) | exception Failed d -> drop o; Error d)
      | exception Failed d ->
        drop o;
        Error d
      | exception e ->
        drop o;
        raise e)

let write_one path f =
  let o = start path in
  match
    let result = f (put o) in
    finish o;
    result
  with
  | result -> (o, result)
  | exception e ->
    drop o;
    raise e

let write files =
  let written = ref [] in
  match
    List.iter (fun (path, f) -> written := fst (write_one path f) :: !written) files;
    Critical.run (fun () -> List.iter settle (List.rev !written))
  with
  | () -> Ok ()
  | exception Failed d ->
    List.iter drop !written;
    Error d
  | exception e ->
    List.iter drop !written;
    raise e

let with_file path f =
  match
    let o, result = write_one path f in
    (try settle o with e -> drop o; raise e);
    result
  with
  | result -> Ok result
  | exception Failed d -> Error d
