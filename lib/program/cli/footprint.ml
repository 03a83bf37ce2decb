open Scc_base

let page = 4096.
let of_heap () = float_of_int (Memory.bytes_of_words (Memory.heap_words ()))

let words line = List.filter (fun w -> w <> "") (String.split_on_char ' ' line)

(* The first line of a file that is what is looked for. *)
let line_of path is_it =
  match open_in_bin path with
  | exception Sys_error _ -> None
  | file ->
    let rec find () =
      match input_line file with
      | exception (End_of_file | Sys_error _) -> None
      | line when is_it line -> Some line
      | _ -> find ()
    in
    let line = find () in
    close_in_noerr file;
    line

type memory = { addresses : float; resident : float; shared : float }

let memory () =
  match Option.map words (line_of "/proc/self/statm" (fun _ -> true)) with
  | Some (addresses :: resident :: shared :: _) ->
    let bytes text = page *. float_of_string text in
    Some { addresses = bytes addresses; resident = bytes resident; shared = bytes shared }
  | Some _ | None -> None

let resident () = match memory () with Some m -> m.resident -. m.shared | None -> of_heap ()

type room = { limit : float; before : float; most : float }

(* What is left at the end is for steps between two looks: heaps grow by leaps, and tables double. *)
let usable = 0.6

let limit () =
  let name = "Max address space" in
  let is_it line =
    String.length line > String.length name && String.equal (String.sub line 0 (String.length name)) name
  in
  match Option.map words (line_of "/proc/self/limits" is_it) with
  | Some (_ :: _ :: _ :: soft :: _) -> float_of_string_opt soft
  | Some _ | None -> None

(* Since the program began. *)
let room =
  match (limit (), memory ()) with
  | Some limit, Some { addresses; _ } when limit < infinity ->
    Some { limit; before = addresses; most = Float.max 1. (usable *. (limit -. addresses)) }
  | _ -> None

let is_limited = Option.is_some room

let told =
  let text { limit; _ } =
    Printf.sprintf "scc: memory is bounded by the addresses that the system gives: %.0f MiB (ulimit -v)"
      (limit /. 1048576.)
  in
  Option.map text room

let at_most words =
  match room with
  | Some { most; _ } -> Int.max 1 (Int.min words (Memory.words_of_bytes (int_of_float most)))
  | None -> words

let taken () =
  match room with
  | None -> 0.
  | Some { before; most; _ } -> (
      match memory () with Some { addresses; _ } -> (addresses -. before) /. most | None -> 0.)
