open Scc_base
open Scc_graph_search
open Scc_verify

type t = {
  clock : unit -> float;
  mutable phases : (string * float) list;  (** the last that was begun first *)
  mutable within : float;  (** the seconds of phases within the one that is under way *)
}

let start ?(clock = Unix.gettimeofday) () = { clock; phases = []; within = 0. }

let phase t name f =
  let before = t.clock () and outside = t.within in
  t.within <- 0.;
  if not (List.mem_assoc name t.phases) then t.phases <- (name, 0.) :: t.phases;
  let ended () =
    let took = Float.max 0. (t.clock () -. before) in
    let own = Float.max 0. (took -. t.within) in
    t.phases <- List.map (fun (n, sum) -> (n, if String.equal n name then sum +. own else sum)) t.phases;
    t.within <- outside +. took
  in
  match f () with
  | result ->
    ended ();
    result
  | exception e ->
    ended ();
    raise e

(* As the system counts it, where it says so. *)
let peak_resident () =
  let kib line =
    match String.split_on_char ':' line with
    | [ "VmHWM"; rest ] -> (
        match String.split_on_char ' ' (String.trim rest) with
        | [ n; "kB" ] -> Option.map (fun n -> n * 1024) (int_of_string_opt n)
        | _ -> None)
    | _ -> None
  in
  match open_in "/proc/self/status" with
  | exception Sys_error _ -> None
  | channel ->
    let rec find () =
      match input_line channel with
      | line -> ( match kib line with Some n -> Some n | None -> find ())
      | exception (End_of_file | Sys_error _) -> None
    in
    let found = find () in
    close_in_noerr channel;
    found

let seconds t = List.rev t.phases

let booking t (attempt : Limits.attempt) : Limits.attempt =
  let run stage f =
    match (stage : Limits.stage) with
    | Concluding -> phase t "conclude" (fun () -> attempt.run stage f)
    | Proving -> phase t "prove" (fun () -> attempt.run stage f)
    | Exploring | Reporting -> attempt.run stage f
  in
  { run }

let exploring t = Option.value ~default:0. (List.assoc_opt "explore" t.phases)
let per_second n seconds = if seconds > 0. then int_of_float (float_of_int n /. seconds) else 0

let lines t (r : Check.report) =
  let s = r.stats in
  let gc = Gc.quick_stat () in
  let mib bytes = Printf.sprintf "%.1f MiB" (float_of_int bytes /. float_of_int Memory.mib) in
  let rate = per_second s.states (exploring t) and edges = per_second s.transitions (exploring t) in
  let resident = match peak_resident () with Some n -> ", resident " ^ mib n | None -> "" in
  [
    "measured (varies from run to run):";
    Printf.sprintf "  states %d, transitions %d, depth %d" s.states s.transitions s.depth;
    Printf.sprintf "  rate: %d states/s, %d transitions/s" rate edges;
    Printf.sprintf "  memory, at most: heap %s%s" (mib (Memory.bytes_of_words gc.top_heap_words)) resident;
    "  stores: "
    ^ String.concat ", " (List.map (fun (name, n) -> Printf.sprintf "%s %s" name (mib n)) r.stores);
    "  longest numbers, in bits: "
    ^ String.concat ", " (List.map (fun (name, n) -> Printf.sprintf "%s %d" name n) (r.numbers ()));
    Printf.sprintf "  collections: %d minor, %d major" gc.minor_collections gc.major_collections;
    "  seconds: "
    ^ String.concat ", " (List.map (fun (name, x) -> Printf.sprintf "%s %.3f" name x) (seconds t));
  ]

let numbers t (r : Check.report) : Scc_reports.Measured_json.t =
  let s = r.stats in
  let gc = Gc.quick_stat () in
  {
    states_per_second = per_second s.states (exploring t);
    transitions_per_second = per_second s.transitions (exploring t);
    peak_heap_bytes = Memory.bytes_of_words gc.top_heap_words;
    peak_resident_bytes = peak_resident ();
    store_bytes = r.stores;
    longest_numbers = r.numbers ();
    minor_collections = gc.minor_collections;
    major_collections = gc.major_collections;
    microseconds = List.map (fun (name, x) -> (name, int_of_float (x *. 1e6))) (seconds t);
  }
