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

type memory = { addresses : float; resident : float; shared : float; data : float }

let memory () =
  match Option.map words (line_of "/proc/self/statm" (fun _ -> true)) with
  | Some [ addresses; resident; shared; _; _; data; _ ] ->
    let bytes text = page *. float_of_string text in
    Some { addresses = bytes addresses; resident = bytes resident; shared = bytes shared; data = bytes data }
  | Some _ | None -> None

let resident () = match memory () with Some m -> m.resident -. m.shared | None -> of_heap ()

type room = { of_memory : memory -> float; limit : float; before : float; most : float }

(* What is left at the end is for steps between two looks: heaps grow by leaps, and tables double. *)
let usable = 0.6

let limit name =
  let is_it line =
    String.length line > String.length name && String.equal (String.sub line 0 (String.length name)) name
  in
  match Option.map words (line_of "/proc/self/limits" is_it) with
  | Some (_ :: _ :: _ :: soft :: _) -> float_of_string_opt soft
  | Some _ | None -> None

let room (name, of_memory) =
  match (limit name, memory ()) with
  | Some limit, Some m when limit < infinity ->
    let before = of_memory m in
    Some { of_memory; limit; before; most = Float.max 1. (usable *. (limit -. before)) }
  | _ -> None

(* Since the program began. *)
let rooms =
  List.filter_map room
    [ ("Max address space", fun m -> m.addresses); ("Max data size", fun m -> m.data) ]

let is_limited = match rooms with [] -> false | _ :: _ -> true

let words_of bytes = Memory.words_of_bytes (int_of_float (Float.min bytes (float_of_int max_int /. 2.)))

(* What test/limits/deep.py runs everything with. *)
let enough_stack = 1048576.

let small_stack =
  match limit "Max stack size" with
  | Some bytes when bytes < enough_stack -> Some (int_of_float bytes / 1024)
  | Some _ | None -> None

let at_most words = List.fold_left (fun words room -> Int.max 1 (Int.min words (words_of room.most))) words rooms

let least = function
  | [] -> None
  | first :: rest -> Some (List.fold_left (fun a b -> if b.most < a.most then b else a) first rest)

let room_below words =
  match least rooms with
  | Some room when words_of room.most < words -> Some (words_of room.limit)
  | Some _ | None -> None

let taken () =
  match (rooms, if is_limited then memory () else None) with
  | [], _ | _, None -> 0.
  | rooms, Some m ->
    List.fold_left (fun taken room -> Float.max taken ((room.of_memory m -. room.before) /. room.most)) 0. rooms
