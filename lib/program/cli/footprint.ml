open Scc_base
open Scc_system

let page = 4096.
let of_heap () = float_of_int (Memory.bytes_of_words (Memory.heap_words ()))

let words line = List.filter (fun w -> w <> "") (String.split_on_char ' ' line)

let first_line path =
  match open_in_bin path with
  | exception Sys_error _ -> None
  | file ->
    let line = match input_line file with line -> Some line | exception (End_of_file | Sys_error _) -> None in
    close_in_noerr file;
    line

type memory = { addresses : float; resident : float; shared : float; data : float }

let memory () =
  match Option.map words (first_line "/proc/self/statm") with
  | Some [ addresses; resident; shared; _; _; data; _ ] ->
    let bytes text = page *. float_of_string text in
    Some { addresses = bytes addresses; resident = bytes resident; shared = bytes shared; data = bytes data }
  | Some _ | None -> None

let resident () = match memory () with Some m -> m.resident -. m.shared | None -> of_heap ()

type room = { of_memory : memory -> float; limit : float; before : float; most : float }

(* What is left at the end is for steps between two looks: heaps grow by leaps, and tables double. *)
let usable = 0.6

let room (limit, of_memory) =
  match (Resources.limit limit, memory ()) with
  | Some limit, Some m ->
    let limit = float_of_int limit and before = of_memory m in
    Some { of_memory; limit; before; most = Float.max 1. (usable *. (limit -. before)) }
  | _ -> None

(* Since the program began. *)
let rooms =
  List.filter_map room [ (Resources.Addresses, fun m -> m.addresses); (Resources.Data, fun m -> m.data) ]

let is_limited = match rooms with [] -> false | _ :: _ -> true

let words_of bytes = Memory.words_of_bytes (int_of_float (Float.min bytes (float_of_int max_int /. 2.)))

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
