open Scc_base
open Scc_exact
open Scc_ctl
open Scc_property
open Scc_semantics
open Scc_state_space
open Scc_json
open Scc_runs
open Json_format

let file = "successors"
let named name t = named ~file name t
let maybe_number = nullable Shared.rational

let diagnostic = named "diagnostic" Diag_json.brief

let truth =
  let reason : Truth.t -> string option = function Undecided why -> Some why | True | False -> None in
  let known : Truth.t -> bool option = function
    | True -> Some true
    | False -> Some false
    | Undecided _ -> None
  in
  union [ case bool known ignore; case (fields [ field "undecided" text Fun.id ]) reason ignore ]
  |> named "truth"

let label =
  all
    [
      field "label" some_text (fun (model, (l, _)) -> Transition.label_to_string model l);
      field "duration" Shared.rational (fun (_, (l, _)) -> Transition.duration_of l);
      maybe "chance" Shared.rational (fun (_, (_, chance)) -> chance);
    ]

(* {1 States} *)

let goals = array truth |> about "Of a state, for each goal of the header." |> named "goals"

let state =
  from (fun (f, (r : Filter.reached)) -> Keys.bytes (Filter.keys f) r.tuple) Shared.bytes
  |> about "Its bytes (specs/state-bytes.md) in hexadecimal digits." |> named "state"

let fingerprint =
  let digits = { Json_schema.set = "0-9a-f"; least = 32; most = Some 32 } in
  from (fun (_, (r : Filter.reached)) -> Keys.hex r.fingerprint) (form [ digits ]) |> named "fingerprint"

let goals_of (_, (r : Filter.reached)) = r.goals

let target =
  let too_long (_, (r : Filter.reached)) = if r.too_long then Some () else None in
  all
    [
      field "state" state Fun.id;
      field "fingerprint" fingerprint Fun.id;
      field "goals" goals goals_of;
      maybe "too_long" (constant (`Bool true)) too_long
        ~about:"A number in it is longer than --bits; else it is not there.";
    ]

let ahead =
  let met =
    fields
      [
        field "choice" (nullable natural) (fun (m : Filter.met) -> m.choice);
        field "offset" some_text (fun (m : Filter.met) -> Algebraic.to_string m.moment.offset)
          ~about:"The time since the state: a rational, or a root.";
        field "attained" bool (fun (m : Filter.met) -> m.moment.attained);
      ]
  in
  let one =
    fields
      [
        field "met" (nullable met) (fun (a : Filter.ahead) -> a.met);
        field "doubt" (nullable text) (fun (a : Filter.ahead) -> a.doubt);
      ]
  in
  array (nullable one) |> about "After the state, before the next one, for each goal." |> named "ahead"

let reason : _ Filter.following -> Diag.t option = function
  | Ends d | Fault d -> Some d
  | Moves _ | Rests | Stops -> None

(* Which members go with what follows: as keywords, and as what is wrong. *)
let by_follows : (string * Json.t) list * (Json.t -> string option) =
  let follows keyword value : string * Json.t =
    ("if", `Assoc [ ("properties", `Assoc [ ("follows", `Assoc [ (keyword, value) ]) ]) ])
  in
  let needs_reason = `Assoc [ ("required", `List [ `String "reason" ]) ] in
  let successors keyword n : Json.t =
    `Assoc [ ("properties", `Assoc [ ("successors", `Assoc [ (keyword, `Int n) ]) ]) ]
  in
  let with_reason =
    [
      follows "enum" (`List [ `String "ends"; `String "fault" ]); ("then", needs_reason);
      ("else", `Assoc [ ("not", needs_reason) ]);
    ]
  in
  let with_successors =
    [
      follows "const" (`String "moves"); ("then", successors "minItems" 1); ("else", successors "maxItems" 0);
    ]
  in
  let wrong json =
    let follows = Option.bind (Json.member "follows" json) Json.string in
    let has_reason = Option.is_some (Json.member "reason" json) in
    let moves = match Json.member "successors" json with Some (`List []) -> false | _ -> true in
    if has_reason <> (follows = Some "ends" || follows = Some "fault") then
      Some "has a `reason` with another end than `ends` and `fault`, or has none with these"
    else if moves <> (follows = Some "moves") then Some "has successors where nothing moves, or has none"
    else None
  in
  ([ ("allOf", `List [ `Assoc with_reason; `Assoc with_successors ]) ], wrong)

let answer =
  let of_state f (filter, (e : Filter.expanded)) = f (filter, e.state) in
  let follows (_, (e : Filter.expanded)) =
    match e.follows with
    | Moves _ -> "moves"
    | Rests -> "rests"
    | Ends _ -> "ends"
    | Stops -> "stops"
    | Fault _ -> "fault"
  in
  let looked (_, (e : Filter.expanded)) = if Array.exists Option.is_some e.ahead then Some e.ahead else None in
  let moves (f, (e : Filter.expanded)) =
    let model = (Filter.question f).loaded.model in
    let move (number, r) = ((model, Filter.label f number), (f, r)) in
    match e.follows with Moves moves -> List.map move moves | Rests | Ends _ | Stops | Fault _ -> []
  in
  let keywords, wrong = by_follows in
  fields
    [
      field "fingerprint" fingerprint (of_state Fun.id);
      field "goals" goals (of_state goals_of);
      maybe "ahead" ahead looked;
      field "follows" (word Fun.id [ "moves"; "rests"; "ends"; "stops"; "fault" ]) follows;
      maybe "reason" diagnostic (fun (_, (e : Filter.expanded)) -> reason e.follows);
      field "successors" (list (fields [ within fst label; within snd target ])) moves;
    ]
  |> constrained keywords wrong |> about "What follows a state." |> named "successors"

(* {1 The header} *)

let plan =
  let form name t part = case (fields [ field name t Fun.id ]) part ignore in
  recursive ~file "plan" (fun plan ->
      union
        [
          form "now" truth (function Question.Now t -> Some t | _ -> None);
          form "possibly" natural (function Question.Possibly k -> Some k | _ -> None);
          form "always" natural (function Question.Always k -> Some k | _ -> None);
          form "all" (list plan) (function Question.All plans -> Some plans | _ -> None);
          form "any" (list plan) (function Question.Any plans -> Some plans | _ -> None);
        ]
      |> about "How a verdict is made of goals.")

let check =
  let with_plan (_, (_, (p : Question.plan))) = match p with Other -> None | _ -> Some p in
  fields
    [
      field "name" text (fun (_, ((c : Property.check), _)) -> c.name);
      field "formula" text (fun (_, ((c : Property.check), _)) -> c.text);
      field "premise" bool (fun (q, (c, _)) -> Question.is_premise q c);
      field "plan" (nullable plan) with_plan;
    ]

let goal =
  fields
    [
      field "formula" text (fun (model, (g : Question.goal), _) -> Show.prop model g.prop);
      field "within" maybe_number (fun (_, (g : Question.goal), _) -> g.within);
      field "ahead" bool (fun (_, _, (p : On_the_fly.predicate)) -> Option.is_some p.along);
    ]

let bounds =
  let instant _ =
    match Scc_verify.Bounds.default.instant with Unbounded -> None | Default n | Given n -> Some n
  in
  fields [ field "instant" (nullable natural) instant; field "bits" natural (fun (q : Question.t) -> q.bits) ]

type owner = { number : int; count : int; port : int }
type header = { program : string; framing : string; owner : owner option; filter : Filter.t }

let owner =
  fields
    [
      field "number" Shared.from_one (fun o -> o.number);
      field "count" Shared.from_one (fun o -> o.count);
      field "port" natural (fun o -> o.port);
    ]
  |> about "Of an owner: which one of how many it is, and where others call it."

let header =
  let question f h = f (Filter.question h.filter) in
  let model (q : Question.t) = q.loaded.model in
  let goals h =
    let q = Filter.question h.filter in
    let goal g p = (model q, g, p) in
    Array.to_list (Array.map2 goal q.goals (Filter.predicates h.filter))
  in
  let events h = List.map (question (fun q -> Show.event (model q)) h) (Filter.events h.filter) in
  fields
    (Shared.head "scc-successors" 2
     @ [
       field "program" some_text (fun h -> h.program);
       fixed "state_bytes" (`Int Scc_codec.State_codec.version) ~about:"Version of specs/state-bytes.md.";
       within (question (fun q -> q.loaded.origin)) Origin_json.fields;
       field "framing" (word Fun.id [ "lines"; "batches"; "owner" ]) (fun h -> h.framing);
       maybe "owner" owner (fun h -> h.owner);
       field "reductions"
         (list ~distinct:true (word Reduction.name Question.reductions))
         (question (fun q -> q.reductions));
       field "bounds" bounds (question Fun.id);
       field "exploration" Shared.from_one (question (fun q -> q.number));
       field "explorations" Shared.from_one (question (fun q -> q.count));
       field "horizon" maybe_number
         (question Question.horizon);
       field "left_out" Shared.texts (question (fun q -> q.exploration.left_out));
       field "checks" (list check) (question (fun q -> List.map (fun c -> (q, c)) q.plans));
       field "goals" (list goal) goals;
       field "events" Shared.texts events;
       field "initial" (named "target" (obj target)) (fun h -> (h.filter, Filter.initial h.filter));
     ])
  |> named "header"

(* {1 Lines} *)

type t =
  | Header of header
  | Answer of Filter.t * Filter.expanded
  | Run of Property.check * (int * Schedule.t)
  | Cycle of int * (int * Schedule.t)
  | Refused of Diag.t

let run =
  fields
    [
      field "check" text (fun ((c : Property.check), _) -> c.name);
      field "schedule" (document ~file:"schedule" Schedule.format) snd;
    ]
  |> about "A run that was found, by the rules." |> named "run"

let cycle =
  fields [ field "cycle" natural fst; field "schedule" (document ~file:"schedule" Schedule.format) snd ]
  |> about "A run that comes back, within one instant, to the state after its first `cycle` transitions."
  |> named "cycle"

let refused =
  fields [ field "error" diagnostic Fun.id ] |> about "A line that is no state, or no run." |> named "refused"

let format =
  union
    [
      case header (function Header h -> Some h | _ -> None) ignore;
      case answer (function Answer (f, e) -> Some (f, e) | _ -> None) ignore;
      case run (function Run (check, schedule) -> Some (check, schedule) | _ -> None) ignore;
      case cycle (function Cycle (from, schedule) -> Some (from, schedule) | _ -> None) ignore;
      case refused (function Refused d -> Some d | _ -> None) ignore;
    ]
  |> about
    "A line of the output is a header (the first one), or an answer. The meaning is in specs/successors.md."

let line t = Json.line (write format t)

(* {1 Texts in frames} *)

type note = { index : int; looked : Filter.ahead option array option; why : Diag.t option; error : Diag.t option }

let not_empty = function [] -> None | list -> Some list

let moves_text =
  let bare json = match json with `Assoc [ _ ] -> Some "says nothing" | _ -> None in
  let note =
    fields
      [
        field "index" natural (fun n -> n.index);
        maybe "ahead" ahead (fun n -> n.looked);
        maybe "reason" diagnostic (fun n -> n.why);
        maybe "error" diagnostic (fun n -> n.error);
      ]
    |> constrained [ ("minProperties", `Int 2) ] bare
  in
  fields
    [
      maybe "labels" (list ~least:1 (obj label)) (fun (labels, _) -> not_empty labels)
        ~about:"Those that come up for the first time, numbered on.";
      maybe "notes" (list ~least:1 note) (fun (_, notes) -> not_empty notes);
    ]
  |> about "The text of the frames moves and states." |> named "moves_text"

let targets_text =
  let note = fields [ field "index" natural fst; field "goals" goals snd ] in
  fields [ maybe "notes" (list ~least:1 note) not_empty ]
  |> about "The text of the frames targets and news." |> named "targets_text"

let text format x = match write format x with `Assoc [] -> "" | json -> Json.line json
let of_moves model labels notes = text moves_text (List.map (fun l -> (model, l)) labels, notes)
let of_targets = text targets_text
