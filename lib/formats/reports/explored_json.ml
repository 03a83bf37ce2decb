open Scc_base
open Scc_calculus
open Scc_verify
open Scc_json
open Scc_runs
open Json_format

let file = Witness_json.file

(* {1 Bounds} *)

(* A value of a bound, as JSON. *)
let limit : Verdict.limit -> string * Json.t = function
  | Depth n -> ("depth", `Int n)
  | Time t -> ("time", Json.rat t)
  | Instant n -> ("instant", `Int n)
  | States n | Draws { states = n; bodies = _ } -> ("states", `Int n)
  | Bits n -> ("bits", `Int n)
  | Seconds s -> ("seconds", `String (Printf.sprintf "%g" s))
  | Memory words -> ("memory", `Int (Memory.bytes_of_words words))
  | Interrupted -> ("interrupted", `Null)
  | Omission p -> ("hash-compaction", `String (Verdict.at_most p))

let limits =
  [ "depth"; "time"; "instant"; "states"; "bits"; "seconds"; "memory"; "interrupted"; "hash-compaction" ]

let origin : Verdict.origin -> string = function
  | By_default -> "default"
  | By_user | By_share -> "user"
  | By_property -> "property"
  | By_system -> "system"

let truncation =
  let value =
    union
      [
        case (integer ()) (function `Int n -> Some n | _ -> None) ignore;
        case text (function `String s -> Some s | _ -> None) ignore;
        case null (fun _ -> Some ()) ignore;
      ]
  in
  fields
    [
      field "limit" (word Fun.id limits) (fun (t : Verdict.truncation) -> fst (limit t.limit));
      field "value" value (fun (t : Verdict.truncation) -> snd (limit t.limit));
      field "origin" (word origin [ By_default; By_user; By_property; By_system ]) (fun (t : Verdict.truncation) ->
          t.origin);
    ]
  |> about
    "A bound that was met, and whose it is; \"system\": that of the process, as by ulimit -v. Memory is in bytes."
  |> named ~file:"check" "truncation"

let left_out =
  about "Something that belongs here is not shown, or not all of it: making it ended at this." truncation
  |> named ~file "left_out"

(* {1 What was explored} *)

let messages = List.map (fun (d : Diag.t) -> d.message)

let cause =
  let kinds = [ "steps"; "numbers"; "leaves"; "drifts"; "times"; "orders"; "splits"; "draws"; "grid" ] in
  let bodies ((m : Model.t), c) = List.map (fun i -> m.leaves.(i).name) (Growth.leaves c) in
  fields
    [
      field "kind" (word Fun.id kinds) (fun (_, c) -> Growth.kind c);
      field "bodies" Shared.texts bodies ~about:"Whom it is about; empty when it is about all.";
      field "text" some_text (fun (m, c) -> Growth.to_string m c) ~about:"What was seen.";
      field "cure" some_text (fun (m, c) -> Growth.cure m c) ~about:"What helps.";
    ]

let format =
  let part f (_, (s : Stats.t)) = f s in
  let causes (m, (s : Stats.t)) =
    match s.causes with [] -> None | causes -> Some (List.map (fun c -> (m, c)) causes)
  in
  fields
    [
      field "states" natural (part (fun s -> s.states));
      field "transitions" natural (part (fun s -> s.transitions));
      field "depth" natural (part (fun s -> s.depth)) ~about:"The greatest of the states' least depths.";
      field "time" (nullable Shared.rational) (part (fun s -> s.model_time))
        ~about:
          "The greatest of the states' earliest arrivals, in model time; null of sets of states, and where \
           nothing was explored.";
      field "complete" bool (part (fun s -> s.complete)) ~about:"Every state was expanded.";
      field "decided_early" bool (part (fun s -> s.decided_early))
        ~about:"The exploration ended because every property was decided.";
      field "stopped_by" (list truncation) (part (fun s -> s.stopped_by));
      field "faults" Shared.texts (part (fun s -> messages s.faults));
      field "dead_ends" Shared.texts (part (fun s -> messages s.dead_ends))
        ~about:"Why runs end in states without transitions (SC0602).";
      maybe "likely_causes" (list ~least:1 cause) causes
        ~about:
          "Why a bound ended the exploration, as far as what was explored tells: which values kept being new. \
           A guess, the most likely first, and no claim about what was not explored.";
      maybe "causes_left_out" left_out (part (fun s -> s.left_out));
    ]
  |> named ~file "explored"
