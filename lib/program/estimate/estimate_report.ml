open Scc_exact
open Scc_loading
open Scc_verdicts
open Scc_json
open Scc_runs
open Estimation

type t = {
  origin : Origin.t;
  aim : aim;
  seed : int64;
  answers : answer list;
  left_out : (string * string) list;
  interrupted : bool;
}

let word = function
  | Estimated -> "estimated"
  | Holds -> "estimated to hold"
  | Violated -> "estimated to be violated"
  | Undecided -> "undecided"

(* {1 For people} *)

let places = 6
let scale = Rat.make (Z.pow (Z.of_int 10) places) Z.one
let decimal = Decimal.fixed ~places
let down r = decimal (Rat.div (Rat.make (Rat.floor (Rat.mul r scale)) Z.one) scale)
let up r = decimal (Rat.neg (Rat.div (Rat.make (Rat.floor (Rat.mul (Rat.neg r) scale)) Z.one) scale))

let mean_text = function Some mean -> decimal mean ^ ", " | None -> ""

(* The share of the runs that do, where there are some and it is known of each. *)
let share (t : Tally.t) =
  if t.runs = 0 || Tally.open_ended t > 0 then "" else decimal (Rat.make (Z.of_int t.yes) (Z.of_int t.runs)) ^ ", "

let line (a : answer) ~confidence =
  let sure = "with confidence " ^ Rat.to_string confidence in
  let runs = Printf.sprintf "%d runs" a.tally.runs in
  match a.value with
  | Probability (low, high) ->
    Printf.sprintf "%sfrom %s to %s %s, %s" (share a.tally) (down low) (up high) sure runs
  | Mean { mean; low; high } ->
    Printf.sprintf "%sfrom %s to %s %s, %s" (mean_text mean) (down low) (up high) sure runs
  | Sample { mean; deviation } ->
    let spread =
      match deviation with
      | Some d -> Printf.sprintf ", with the standard deviation %s" (decimal d)
      | None -> ""
    in
    Printf.sprintf "the mean of these runs alone is %s%s, %s" (decimal mean) spread runs
  | Infinite -> Printf.sprintf "infinite: %d of %s never come to it" a.tally.never runs
  | Unknown -> "not known, " ^ runs

(* {1 For programs} *)

let value : value -> Json.t = function
  | Unknown -> `Null
  | Infinite -> `Assoc [ ("kind", `String "infinite") ]
  | Probability (low, high) ->
    `Assoc [ ("kind", `String "probability"); ("low", Json.rat low); ("high", Json.rat high) ]
  | Mean { mean; low; high } ->
    `Assoc
      [
        ("kind", `String "mean");
        ("mean", Json.option Json.rat mean);
        ("low", Json.rat low);
        ("high", Json.rat high);
      ]
  | Sample { mean; deviation } ->
    `Assoc
      [ ("kind", `String "sample"); ("mean", Json.rat mean); ("deviation", Json.option Json.rat deviation) ]

let verdict = function
  | Estimated -> "estimated"
  | Holds -> "estimated_holds"
  | Violated -> "estimated_violated"
  | Undecided -> "undecided"

let answer (a : answer) : Json.t =
  let t = a.tally in
  `Assoc
    [
      ("name", `String a.path.check.name);
      ("text", Json.text a.path.check.text);
      ("verdict", `String (verdict a.verdict));
      ("value", value a.value);
      ("runs", `Int t.runs);
      ("yes", `Int t.yes);
      ("no", `Int t.no);
      ("numbers", `Int (t.numbers));
      ("never", `Int t.never);
      ("free", `Int t.free);
      ("too_long", `Int t.too_long);
      ("no_value", `Int t.no_value);
      ("chosen_evenly", `Bool a.chosen);
      ("reasons", `List (List.map Json.text a.reasons));
    ]

let json t ~exit : Json.t =
  let left (name, why) : Json.t = `Assoc [ ("name", `String name); ("reason", Json.text why) ] in
  let sequential = match t.aim.size with Exactly _ -> false | At_most _ -> true in
  `Assoc
    ([
      ("format", `String "scc-estimate");
      ("version", `Int 2);
      ("semantics", `String Scc_calculus.Parameters.version);
    ]
      @ Origin_json.members t.origin
      @ [
        ("seed", `String (Int64.to_string t.seed));
        ("confidence", Json.rat t.aim.confidence);
        ("width", Json.rat t.aim.width);
        ("sequential", `Bool sequential);
        ("free", `String (match t.aim.free with Apart -> "apart" | Evenly -> "evenly"));
        ("interrupted", `Bool t.interrupted);
        ("exit", `Int (Exit_code.to_int exit));
        ("properties", `List (List.map answer t.answers));
        ("left_out", `List (List.map left t.left_out));
      ])
