open Scc_base

exception Failed of Diag.t

(* [path] is what the user knows the file [place] by. *)
let fail ~path place message =
  raise
    (Failed
       (Diag.error Code.cannot_write
          (Span.make ~file:path ~start:0 ~stop:0)
          "cannot write: %s" (Os_error.reason place message)))

(* To rename over a device or a link would do away with it. *)
let replaceable path =
  match Unix.lstat path with
  | { st_kind = S_REG; _ } -> true
  | _ -> false
  | exception Unix.Unix_error (ENOENT, _, _) -> true
  | exception Unix.Unix_error _ -> false

let beside path = Printf.sprintf "%s.%d.part" path (Unix.getpid ())
let remove path = try Sys.remove path with Sys_error _ -> ()

let write_to place ~path f =
  let out = try open_out_bin place with Sys_error m -> fail ~path place m in
  let put s = try output_string out s with Sys_error m -> fail ~path place m in
  match f put with
  | () -> ( try close_out out with Sys_error m -> close_out_noerr out; fail ~path place m)
  | exception e ->
    close_out_noerr out;
    raise e

let write files =
  let placed =
    List.map (fun (path, f) -> (path, (if replaceable path then beside path else path), f)) files
  in
  let is_new (path, place, _) = not (String.equal path place) in
  let clean () = List.iter (fun ((_, place, _) as file) -> if is_new file then remove place) placed in
  let rename ((path, place, _) as file) =
    if is_new file then try Sys.rename place path with Sys_error m -> fail ~path path m
  in
  match
    List.iter (fun (path, place, f) -> write_to place ~path f) placed;
    List.iter rename placed
  with
  | () -> Ok ()
  | exception Failed d ->
    clean ();
    Error d
  | exception e ->
    clean ();
    raise e
