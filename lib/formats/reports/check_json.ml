open Scc_base
open Scc_calculus
open Scc_semantics
open Scc_explain
open Scc_verify
open Scc_loading
open Scc_json
open Scc_runs
open Json_format

type t = {
  loaded : Loaded.t;
  verdicts : Verdict.outcome list;
  where : Scc_regions.Where.t list;
  report : Check.report;
  diagnostics : Diag.t list;
  exit : int;
  coverage : (Explored.t * Coverage.t) option;
  measured : Measured_json.t option;
  full : bool;
  cure : Verdict.outcome -> string option;
}

let kind : Verdict.t -> string = function
  | Holds { bounds = []; _ } -> "holds"
  | Holds _ -> "holds-up-to-bound"
  | Violated _ -> "violated"
  | Measured _ -> "measured"
  | Depends d -> (
      match Verdict.everywhere d with None -> "measured" | Some true -> "holds" | Some false -> "violated")
  | Undecided _ -> "undecided"

let kind_format = word Fun.id [ "holds"; "holds-up-to-bound"; "violated"; "measured"; "undecided" ]

let file = Witness_json.file
let lost = list ~least:1 ~distinct:true text

let lost_members =
  let t =
    about
      "Faults of scc, by which a run that belongs here could not be rebuilt, and is not shown. All else is as \
       usual; the exit code is 70."
      lost
    |> named ~file "lost"
  in
  maybe "lost" t (function [] -> None | faults -> Some faults)

(* {1 Properties} *)

(* A verdict with what its report depends on. *)
type judged = {
  semantics : Semantics.t;
  outcome : Verdict.outcome;
  whole : bool;
  likely_cure : string option;
  holds_where : Scc_regions.Where.t option;
}

let witness_of ?(full = true) j witness = { Witness_json.given = j.semantics; witness; full }

let reason =
  let kinds = [ "truncated"; "unevaluated"; "unexplored"; "undefined"; "fault" ] in
  let kind (_, (r : Verdict.reason)) =
    match r with
    | Truncated _ -> "truncated"
    | Unevaluated _ -> "unevaluated"
    | Undefined _ -> "undefined"
    | Fault _ -> "fault"
    | Unexplored _ -> "unexplored"
  in
  let bound (_, (r : Verdict.reason)) =
    match r with Truncated t | Unevaluated t -> Some t | Undefined _ | Fault _ | Unexplored _ -> None
  in
  (* The way to where an exploration ended may be as long as the exploration, and decides nothing. *)
  let run (j, (r : Verdict.reason)) =
    match r with
    | Unexplored { nearest; _ } -> Some (witness_of ~full:j.whole j nearest)
    | Truncated _ | Unevaluated _ | Undefined _ | Fault _ -> None
  in
  fields
    [
      field "kind" (word Fun.id kinds) kind;
      field "text" some_text (fun (_, r) -> Verdict.reason_to_string r);
      field "bound" (nullable Explored_json.truncation) bound;
      field "witness" (nullable Witness_json.format) run;
    ]

let halt : Witness.halt -> string = function
  | Dead_end -> "dead-end"
  | One_instant -> "one-instant"

let rest =
  let runs : Verdict.rest -> string = function By _ -> "deciding" | Among _ -> "some" in
  fields
    [
      field "runs" (from runs (word Fun.id [ "deciding"; "some" ])) Fun.id;
      field "end" (word halt [ Dead_end; One_instant ]) (function Verdict.By h | Among h -> h)
        ~about:"In a dead end, or by going round within one instant.";
    ]

let convergence =
  let stretch =
    fields
      [
        field "instants" Shared.from_one (fun (x : Slowing.stretch) -> x.instants);
        field "took" Shared.rational (fun (x : Slowing.stretch) -> x.took);
      ]
  in
  let slowing =
    fields
      [
        field "stretches" (list ~least:3 ~most:3 stretch) (fun (s : Slowing.t) -> s.stretches);
        field "until" Shared.rational (fun (s : Slowing.t) -> s.until);
      ]
  in
  let converges = fields [ field "factor" Shared.rational fst; field "until" Shared.rational snd ] in
  all
    [
      maybe "slowing" slowing (function Some (Verdict.Named s) -> Some s | Some (Proved _) | None -> None)
        ~about:
          "Event times grew ever slower where a bound ended the exploration: three stretches of instants, each \
           of twice as many as the one before, and how long they took.";
      maybe "converges" converges (function
          | Some (Verdict.Proved q) -> Some (q.factor, q.until)
          | Some (Named _) | None -> None)
        ~about:
          "Some run repeats itself, this many times as fast each round, and its instants converge to this time.";
    ]

let over =
  let bound =
    fields
      [
        field "value" Shared.rational (fun (b : Ranges.bound) -> b.value);
        field "included" bool (fun (b : Ranges.bound) -> b.included) ~about:"It belongs to the range.";
      ]
    |> named ~file "bound"
  in
  let range =
    fields
      [
        field "parameter" some_text (fun (r : Ranges.range) -> r.name);
        field "low" bound (fun (r : Ranges.range) -> r.low);
        field "high" bound (fun (r : Ranges.range) -> r.high);
      ]
    |> about "A parameter that is not known but for its range." |> named ~file "range"
  in
  fields
    [
      field "instants" bool (fun (o : Verdict.over) -> o.instants)
        ~about:"Weak splits were looked at at all real instants.";
      field "ranges" (array range) (fun (o : Verdict.over) -> o.ranges) ~about:"All values of these parameters.";
      maybe "example" Origin_json.parameters_format (fun (o : Verdict.over) ->
          match o.example with [] -> None | example -> Some example)
        ~about:"Values for which the run is that is shown, or for which it is violated.";
    ]

(* An ordinary model leaves nothing open. *)
let spoken_of (o : Verdict.over) = o.instants || Array.length o.ranges > 0

(* A number, or bounds of it that are proved. *)
let measured =
  let side : Scc_property.Property.side -> string = function Least -> "least" | Greatest -> "greatest" in
  fields
    [
      field "over" (word side [ Least; Greatest ]) fst;
      field "low" (nullable Shared.rational) (fun (_, { Scc_ctl.Eval.least; _ }) -> Scc_chance.Answer.lower least);
      field "high" (nullable Shared.rational) (fun (_, { Scc_ctl.Eval.most; _ }) -> Scc_chance.Answer.upper most);
    ]

let values_format = list ~least:1 ~most:2 measured

(* A number that depends on the start. *)
let by_start =
  let side : Scc_property.Property.side -> string = function Least -> "least" | Greatest -> "greatest" in
  fields
    [
      field "over" (word side [ Least; Greatest ]) fst;
      within snd Where_json.chances_fields;
    ]

let starts j =
  let of_side (side, chances) =
    (side, { Where_json.chances; with_parts = Option.is_some j.holds_where })
  in
  match j.outcome.verdict with
  | Measured { starts = _ :: _ as starts; _ } -> Some (List.map of_side starts)
  | Measured _ | Depends _ | Holds _ | Violated _ | Undecided _ -> None

let curve_point =
  let moment (p : Verdict.point) = p.moment in
  fields
    [
      field "time" Witness_json.instant (fun p -> (moment p).offset);
      maybe "after" (constant (`Bool true)) (fun p -> if (moment p).attained then None else Some ())
        ~about:"It counts after this time, and not yet at it.";
      field "values" values_format (fun (p : Verdict.point) -> p.answer);
    ]

let curve (v : Verdict.t) =
  match v with
  | Measured { curve = _ :: _ as curve; _ } -> Some curve
  | Measured _ | Depends _ | Holds _ | Violated _ | Undecided _ -> None

let bounds (v : Verdict.t) =
  match v with Holds { bounds; _ } -> bounds | Violated _ | Measured _ | Depends _ | Undecided _ -> []

let reasons (v : Verdict.t) =
  match v with Measured { reasons; _ } | Undecided reasons -> reasons | Holds _ | Violated _ | Depends _ -> []

let run (v : Verdict.t) =
  match v with
  | Holds { witness; _ } | Violated { witness } | Measured { witness; _ } -> witness
  | Undecided _ | Depends _ -> None

let some = function [] -> None | _ :: _ as items -> Some items

(* What is undecided rests on no step. *)
let split_step (o : Verdict.outcome) =
  match o.verdict with Undecided _ -> None | Holds _ | Violated _ | Measured _ | Depends _ -> o.scale.split_step

let values (v : Verdict.t) =
  match v with Measured { values; _ } -> Some values | Holds _ | Violated _ | Depends _ | Undecided _ -> None

let property_members =
  let of_outcome part = within (fun j -> j.outcome) part in
  [
    of_outcome
      (all
         [
           field "name" some_text (fun (o : Verdict.outcome) -> o.check.name);
           field "formula" some_text (fun (o : Verdict.outcome) -> o.check.text);
           field "verdict" kind_format (fun (o : Verdict.outcome) -> kind o.verdict);
           field "text" some_text Verdict.outcome_to_string;
           field "bounds" (list Explored_json.truncation) (fun (o : Verdict.outcome) -> bounds o.verdict)
             ~about:"Within which it holds; empty for a proof.";
         ]);
    field "reasons" (list reason) (fun j -> List.map (fun r -> (j, r)) (reasons j.outcome.verdict))
      ~about:"Why it is undecided, or why a number that was asked for is not better known.";
    maybe "inexact" some_text (fun j -> Verdict.inexact j.outcome.verdict)
      ~about:"Why a number is an interval and no fraction, where nothing was left out.";
    field "witness" (nullable Witness_json.format) (fun j -> Option.map (witness_of j) (run j.outcome.verdict));
    maybe "otherwise" Witness_json.otherwise
      (fun j -> Option.bind (Option.map (witness_of j) (run j.outcome.verdict)) Witness_json.contrast)
      ~about:"With --contrast: a run that does otherwise than the witness, and parts from it as late as possible.";
    of_outcome
      (all
         [
           maybe "values" values_format (fun (o : Verdict.outcome) -> values o.verdict)
             ~about:
               "The answer to `= ?`: over the choices of all schedulers, what is the least and the greatest. \
                Where low and high are one, that is the number; else it is proved to be between them.";
           maybe "dependence" Dependence_json.format (fun (o : Verdict.outcome) ->
               match o.verdict with
               | Depends d -> Some d
               | Holds _ | Violated _ | Measured _ | Undecided _ -> None)
             ~about:
               "With --parametric: how a number, or the truth of a claim, depends on the parameter. The claim \
                holds if it does for all values.";
           maybe "curve" (list ~least:1 curve_point) (fun (o : Verdict.outcome) -> curve o.verdict)
             ~about:
               "With --curve: the answer for all ends T of the bound of time up to the given one. Each row counts \
                from its time to that of the next one.";
           maybe "rests_on" (list ~least:1 rest) (fun (o : Verdict.outcome) -> some o.rests)
             ~about:
               "Runs in which time does not go on for ever: the run that decides, or some among all runs when \
                no run decides by itself and the verdict could be another one without them.";
           within (fun (o : Verdict.outcome) -> o.converges) convergence;
           maybe "split_step" Shared.rational split_step
             ~about:
               "Of a verdict whose exploration saw weak splits enabled: they were looked at at multiples of it \
                only.";
           maybe "over" over (fun (o : Verdict.outcome) ->
               Option.bind o.scale.over (fun over -> if spoken_of over then Some over else None))
             ~about:
               "Of what the verdict speaks at once, of models with ranges or with bonds that may be released \
                at any time (rule Zones).";
           within (fun (o : Verdict.outcome) -> o.lost) lost_members;
           maybe "run_left_out" Explored_json.left_out (fun (o : Verdict.outcome) -> o.left_out);
         ]);
    maybe "likely_cure" some_text (fun j -> j.likely_cure)
      ~about:"Where the exploration met a bound: what to ask instead.";
    maybe "by_invariant" (constant (`Bool true)) (fun j ->
        if Verdict.by_invariant j.outcome then Some () else None)
      ~about:"It rests on an invariant (rule Invariants).";
    maybe "starts" (list ~least:1 ~most:2 by_start) starts
      ~about:
        "Of a probability that is asked for all starts: how it depends on them. The scheduler sees the start. \
         Then low and high of `values` bound it for all of them.";
    maybe "where" Where_json.format (fun j ->
        match j.outcome.verdict with
        | Measured _ | Depends _ -> None
        | Undecided _ when Verdict.asks_number j.outcome.check -> None
        | Holds _ | Violated _ | Undecided _ -> j.holds_where)
      ~about:"With --where, unless a number is asked for: for which values of the parameters it holds.";
  ]

(* Which members go with a verdict: as keywords, and as what is wrong. *)
let by_verdict : (string * Json.t) list * (Json.t -> string option) =
  let constant verdict : Json.t = `Assoc [ ("const", `String verdict) ] in
  let is verdict : Json.t = `Assoc [ ("properties", `Assoc [ ("verdict", constant verdict) ]) ] in
  let properties list : string * Json.t = ("properties", `Assoc list) in
  let none name : string * Json.t = (name, `Bool false) in
  let items name keyword n : string * Json.t = (name, `Assoc [ (keyword, `Int n) ]) in
  let rule verdict ?otherwise members : Json.t =
    let otherwise = match otherwise with None -> [] | Some members -> [ ("else", `Assoc members) ] in
    `Assoc ([ ("if", is verdict); ("then", `Assoc members) ] @ otherwise)
  in
  let required name : Json.t = `Assoc [ ("required", `List [ `String name ]) ] in
  let rules =
    [
      rule "holds" [ properties [ items "bounds" "maxItems" 0; items "reasons" "maxItems" 0 ] ];
      rule "holds-up-to-bound" [ properties [ items "bounds" "minItems" 1; items "reasons" "maxItems" 0 ] ];
      rule "measured" ~otherwise:[ properties [ none "values" ] ]
        [
          properties [ items "bounds" "maxItems" 0; none "rests_on" ];
          ("anyOf", `List [ required "values"; required "dependence" ]);
        ];
      rule "undecided" [ properties [ items "reasons" "minItems" 1; none "split_step"; none "rests_on" ] ];
    ]
  in
  let wrong json =
    let has name = match json with `Assoc members -> List.mem_assoc name members | _ -> false in
    let some name = match Json.member name json with Some (`List (_ :: _)) -> true | _ -> false in
    let fits =
      match Option.bind (Json.member "verdict" json) Json.string with
      | Some "holds" -> (not (some "bounds")) && (not (some "reasons")) && not (has "values")
      | Some "holds-up-to-bound" -> some "bounds" && (not (some "reasons")) && not (has "values")
      | Some "measured" -> (not (some "bounds")) && (not (has "rests_on")) && (has "values" || has "dependence")
      | Some "undecided" ->
        some "reasons" && not (has "split_step" || has "rests_on" || has "values")
      | _ -> not (has "values")
    in
    if fits then None else Some "has members that do not go with its verdict"
  in
  ([ ("allOf", `List rules) ], wrong)

let property_format =
  let keywords, wrong = by_verdict in
  constrained keywords wrong (fields property_members) |> named ~file "property"

let judged ?(full = false) ?(cure = fun _ -> None) ?where semantics outcome =
  { semantics; outcome; whole = full; likely_cure = cure outcome; holds_where = where }

(* {1 The report} *)

let slice =
  fields
    [
      field "properties" (list ~least:1 some_text) (fun (_, (s : Check.slice)) -> s.properties);
      field "left_out" (list ~least:1 some_text) (fun (_, (s : Check.slice)) -> s.left_out);
      field "explored" Explored_json.format (fun (m, (s : Check.slice)) -> (m, s.explored));
    ]

let all_judged r =
  let one where outcome = judged ~full:r.full ~cure:r.cure ?where r.loaded.semantics outcome in
  match r.where with
  | [] -> List.map (one None) r.verdicts
  | where -> List.map2 (fun w o -> one (Some w) o) where r.verdicts

let invariants_member =
  maybe "invariants" (list ~least:1 Invariant_json.format) (fun (m, (report : Check.report)) ->
      Option.map (List.map (fun i -> (m, i))) (some report.invariants))
    ~about:"Where invariants were looked for (rule Invariants): each that was found, and why none was."

let format =
  let report part = within (fun (_, r) -> r.report) part in
  let model (_, r) = r.loaded.model in
  let zeno (_, r) =
    Option.map (fun witness -> { Witness_json.given = r.loaded.semantics; witness; full = true }) r.report.zeno
  in
  fields
    (Shared.head "scc-check" 1
     @ [
       Shared.semantics ();
       within (fun (_, r) -> r.loaded.origin) Origin_json.fields;
       field "exit" Shared.exit (fun (_, r) -> r.exit);
       maybe "resolution" Shared.rational (fun r -> Model.resolution (model r))
         ~about:"of a rigid model: contacts are known within this length, and verdicts are meant so";
       field "properties" (list property_format) (fun (_, r) -> all_judged r);
       field "explored" Explored_json.format (fun ((_, r) as x) -> (model x, r.report.stats));
       field "slices" (list slice) (fun ((_, r) as x) -> List.map (fun s -> (model x, s)) r.report.slices)
         ~about:"The explorations that left out leaves that cannot matter for some properties.";
       field "zeno" (nullable Witness_json.format) zeno
         ~about:"A run that goes on for ever within one instant, if one was met.";
       report
         (all
            [
              within (fun (r : Check.report) -> r.lost) lost_members;
              maybe "run_left_out" Explored_json.left_out (fun (r : Check.report) -> r.left_out);
            ]);
       field "diagnostics" Diag_json.formats (fun (source, r) -> (source, r.diagnostics));
       within (fun ((_, r) as x) -> (model x, r.report)) invariants_member;
       maybe "coverage" Coverage_json.format (fun (_, r) -> r.coverage)
         ~about:"With --coverage: what of the model ever came to be, among the states that were explored.";
       maybe "measured" Measured_json.format (fun (_, r) -> r.measured)
         ~about:"With --stats: what the run took, by the clock and in memory. It varies from run to run.";
     ])

let document ~source r = write format (source, r)
