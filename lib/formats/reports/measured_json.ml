open Scc_json
open Json_format

type t = {
  states_per_second : int;
  transitions_per_second : int;
  peak_heap_bytes : int;
  peak_resident_bytes : int option;
  store_bytes : (string * int) list;
  longest_numbers : (string * int) list;
  minor_collections : int;
  major_collections : int;
  microseconds : (string * int) list;
}

(* An object with a number for some of these names. *)
let numbers names = all (List.map (fun name -> maybe name natural (List.assoc_opt name)) names)

let stores = [ "states"; "labels"; "edges" ]

let store_bytes =
  let together = List.map (fun name -> (name, `List (List.map (fun s -> `String s) stores))) stores in
  let wrong json =
    match List.filter (fun name -> Option.is_some (Json.member name json)) stores with
    | [] -> None
    | some -> if List.compare_lengths some stores = 0 then None else Some "has not all that a graph takes"
  in
  constrained [ ("dependentRequired", `Assoc together) ] wrong (obj (numbers stores))

let format =
  fields
    [
      fixed "varies" (`Bool true);
      field "states_per_second" natural (fun t -> t.states_per_second);
      field "transitions_per_second" natural (fun t -> t.transitions_per_second);
      field "peak_heap_bytes" natural (fun t -> t.peak_heap_bytes);
      field "peak_resident_bytes" (nullable (integer ())) (fun t -> t.peak_resident_bytes);
      field "store_bytes" store_bytes (fun t -> t.store_bytes)
        ~about:"What the explored graph takes; empty of one over zones, which is not measured.";
      field "longest_numbers"
        (obj (numbers [ "positions"; "velocities"; "spins"; "orientations"; "angular_momenta" ]))
        (fun t -> t.longest_numbers)
        ~about:
          "How far numbers have grown: the bits of the longest ones, numerator and denominator together; empty \
           over zones.";
      field "minor_collections" natural (fun t -> t.minor_collections);
      field "major_collections" natural (fun t -> t.major_collections);
      field "microseconds" (entries natural) (fun t -> t.microseconds) ~about:"Of each phase.";
    ]
