open Scc_exact
open Scc_loading
open Scc_verdicts
open Scc_json
open Scc_runs
open Json_format
open Estimation

type t = {
  origin : Origin.t;
  aim : aim;
  seed : int64;
  answers : answer list;
  left_out : (string * string) list;
  interrupted : bool;
  source : Scc_runs.Diag_json.source;
  diagnostics : Scc_base.Diag.t list;
}

let word (a : answer) =
  match a.verdict with
  | Estimated -> "estimated"
  | Sampled -> "sampled"
  | Holds -> "estimated to hold"
  | Violated -> "estimated to be violated"
  | Undecided -> (
      match Path.test a.path with
      | None -> "undecided"
      | Some (_, test) -> "undecided whether it is " ^ Scc_chance.Answer.bound_to_string test)

(* What is said of the levels is advice then. *)
let whole_splitting a = match a.splitting with Some s -> s.left = 0 | None -> false

let exit_code a : Exit_code.t =
  match (a.verdict, a.reasons) with
  | Holds, _ | Estimated, [] -> Holds
  | Estimated, _ when whole_splitting a -> Holds
  | Violated, _ -> Violated
  | (Undecided | Sampled), _ | Estimated, _ :: _ -> Undecided

(* {1 For people} *)

let places = 6
let decimal = Decimal.fixed ~places
let down = Decimal.rounded_down ~places
let up = Decimal.rounded_up ~places

let mean_text = function Some mean -> decimal mean ^ ", " | None -> ""

(* The share of the runs that do, where there are some and it is known of each. *)
let share (t : Tally.t) =
  if t.runs = 0 || Tally.open_ended t > 0 then "" else decimal (Rat.make (Z.of_int t.yes) (Z.of_int t.runs)) ^ ", "

(* Four digits and a power of ten, rounded by [round]. *)
let scientific round x =
  let ten k =
    let power = Rat.make (Z.pow (Z.of_int 10) (Int.abs k)) Z.one in
    if k >= 0 then power else Rat.div Rat.one power
  in
  let rec exponent k = if Rat.compare x (ten k) >= 0 then k else exponent (k - 1) in
  if Rat.sign x = 0 then "0"
  else
    let k = exponent 0 in
    let digits = round (Rat.mul x (ten (3 - k))) in
    let number = Decimal.fixed ~places:3 (Rat.make digits (Z.of_int 1000)) in
    if k = 0 then number else Printf.sprintf "%se%d" number k

let ceiling x = Z.neg (Rat.floor (Rat.neg x))

let splitting (s : Splitting.summary) ~confidence =
  let of_level (passed, all) = if all = 0 then "-" else decimal (Rat.make (Z.of_int passed) (Z.of_int all)) in
  let number = scientific Rat.floor and above = scientific ceiling in
  let likely =
    if Rat.compare s.likely s.high >= 0 then ""
    else
      Printf.sprintf
        "\n  at most %s if no repetition gives more than %s, twice the greatest that was found: this is not proved"
        (above s.likely) (above s.assumed)
  in
  Printf.sprintf
    "%s, from %s to %s with confidence %s, %d repetitions%s\n\
    \  share of runs that passed each level, and came to the goal: %s"
    (number s.mean) (number s.low) (above s.high) (Rat.to_string confidence) s.repetitions likely
    (String.concat ", " (List.map of_level s.shares))

let line (a : answer) ~confidence =
  let sure = "with confidence " ^ Rat.to_string confidence in
  let runs = Scc_base.Plural.count a.tally.runs "run" "runs" in
  match a.value with
  | _ when Option.is_some a.splitting -> splitting (Option.get a.splitting) ~confidence
  | Probability (low, high) ->
    Printf.sprintf "%sfrom %s to %s %s, %s" (share a.tally) (down low) (up high) sure runs
  | Mean { mean; low; high } ->
    let ends =
      match (low, high) with
      | Some low, Some high -> Printf.sprintf "from %s to %s" (down low) (up high)
      | Some low, None -> "at least " ^ down low
      | None, Some high -> "at most " ^ up high
      | None, None -> "anything"
    in
    Printf.sprintf "%s%s %s, %s" (mean_text mean) ends sure runs
  | Approximate { mean; low; high } ->
    Printf.sprintf "%s, about from %s to %s: %s if the mean of the runs is normal, %s" (decimal mean) (down low)
      (up high) sure runs
  | Sample { mean; deviation } ->
    let spread =
      match deviation with
      | Some d -> Printf.sprintf ", with the standard deviation %s" (decimal d)
      | None -> ""
    in
    Printf.sprintf "the mean of these runs alone is %s%s, %s" (decimal mean) spread runs
  | Infinite -> Printf.sprintf "infinite: %d of %s never come to it" a.tally.never runs
  | Unknown -> "not known, " ^ runs

let of_known (a : answer) =
  let t = a.tally in
  let opens = Tally.open_ended t and count = Scc_base.Plural.count in
  let others = count opens "run is" "runs are" ^ " open, and may differ" in
  let is_decided = a.verdict = Holds || a.verdict = Violated in
  match Tally.known_mean t with
  | _ when is_decided || Option.is_some a.splitting || opens = 0 -> []
  | Some mean ->
    let known = count t.numbers "run" "runs" in
    [ Printf.sprintf "the mean of the %s with a number is %s; %s" known (decimal mean) others ]
  | None when t.yes + t.no = 0 -> []
  | None ->
    let known = count (t.yes + t.no) "run" "runs" in
    [ Printf.sprintf "it is so in %d of the %s that tell; %s" t.yes known others ]

(* {1 For programs} *)

let value =
  let number = Shared.rational in
  let bounds = all [ field "low" number fst; field "high" number snd ] in
  tagged "kind"
    [
      variant "infinite" (function Infinite -> Some () | _ -> None) (all []) Fun.id;
      variant "probability" (function Probability (low, high) -> Some (low, high) | _ -> None) bounds Fun.id;
      variant "mean"
        (function Mean { mean; low; high } -> Some (mean, (low, high)) | _ -> None)
        (all
           [
             field "mean" (nullable number) fst;
             field "low" (nullable number) (fun (_, (low, _)) -> low);
             field "high" (nullable number) (fun (_, (_, high)) -> high);
           ])
        Fun.id
        ~about:
          "Of a number that is always in a range which is known. The mean over the runs is null if not all have \
           come to a number. An end is null if the range has no such end.";
      variant "normal"
        (function Approximate { mean; low; high } -> Some (mean, (low, high)) | _ -> None)
        (all
           [
             field "mean" number fst;
             field "low" number (fun (_, (low, _)) -> low);
             field "high" number (fun (_, (_, high)) -> high);
           ])
        Fun.id
        ~about:
          "With --normal, of a number without a known range: the interval is approximate, and its confidence is \
           that of a mean with the normal distribution.";
      variant "sample"
        (function Sample { mean; deviation } -> Some (mean, deviation) | _ -> None)
        (all [ field "mean" number fst; field "deviation" (nullable number) snd ])
        Fun.id
        ~about:
          "Of a number of which no range is known: what the runs came to. No interval follows, and the verdict is \
           sampled, or undecided of a comparison. The deviation is null for a single run.";
    ]

let verdict = function
  | Estimated -> "estimated"
  | Sampled -> "sampled"
  | Holds -> "estimated_holds"
  | Violated -> "estimated_violated"
  | Undecided -> "undecided"

let splitting =
  let number = Shared.rational in
  let open Splitting in
  fields
    [
      field "mean" number (fun s -> s.mean) ~about:"Of the estimates of the repetitions; each is without bias.";
      field "assumed" number (fun s -> s.assumed)
        ~about:"Twice the greatest estimate of a repetition: that none is greater is not proved.";
      field "likely" number (fun s -> s.likely) ~about:"The upper end under this assumption.";
      field "left" natural (fun s -> s.left) ~about:"Runs between levels that were left undecided.";
      field "shares"
        (list (fields [ field "passed" natural fst; field "runs" natural snd ]))
        (fun s -> s.shares)
        ~about:"By level, and last the goal.";
    ]

let answer =
  let tally f (a : answer) = f a.tally in
  let known a = match a.value with Unknown -> None | _ -> Some a.value in
  fields
    [
      field "name" text (fun a -> a.path.check.name);
      field "text" text (fun a -> a.path.check.text);
      field "verdict"
        (Json_format.word verdict [ Estimated; Sampled; Holds; Violated; Undecided ])
        (fun (a : answer) -> a.verdict);
      field "value" (nullable value) known;
      field "runs" natural (tally (fun t -> t.runs))
        ~about:"All of them; each is counted in one of the next seven. With splitting, the repetitions.";
      field "yes" natural (tally (fun t -> t.yes));
      field "no" natural (tally (fun t -> t.no));
      field "numbers" natural (tally (fun t -> t.numbers)) ~about:"Runs with a number, of which the mean is.";
      field "known_mean" (nullable Shared.rational) (tally Tally.known_mean)
        ~about:
          "The mean of the runs with a number where other runs are open, which may differ from these: it \
           estimates nothing. Null if no run is open, or none has a number.";
      field "never" natural (tally (fun t -> t.never))
        ~about:"Runs that never come to where the number would be known.";
      field "free" natural (tally (fun t -> t.free))
        ~about:"Runs that depend on a choice that nothing draws.";
      field "too_long" natural (tally (fun t -> t.too_long)) ~about:"Runs that were left before it was known.";
      field "no_value" natural (tally (fun t -> t.no_value));
      field "chosen_evenly" bool (fun a -> a.chosen)
        ~about:"Choices that nothing draws were taken, and the probability is one of that.";
      field "reasons" Shared.texts (fun a -> a.reasons)
        ~about:"Why it is undecided, or not as narrow as was asked for.";
      field "splitting" (nullable splitting) (fun a -> a.splitting) ~about:"With --levels, how it was found.";
    ]

let left_out = fields [ field "name" text fst; field "reason" text snd ]

let format =
  let aim f (t, _) = f t.aim in
  let sequential (a : aim) = match a.size with Exactly _ -> false | At_most _ -> true in
  let free (a : aim) = match a.free with Apart -> "apart" | Evenly -> "evenly" in
  fields
    (Shared.head "scc-estimate" 3
     @ [
       Shared.semantics ();
       within (fun (t, _) -> t.origin) Origin_json.fields;
       field "seed" Shared.seed (fun (t, _) -> t.seed);
       field "confidence" Shared.rational (aim (fun a -> a.confidence)) ~about:"Of each property by itself.";
       field "width" Shared.rational (aim (fun a -> a.width));
       field "sequential" bool (aim sequential)
         ~about:"Looked at again and again; false: once, after --runs.";
       field "free" (Json_format.word Fun.id [ "apart"; "evenly" ]) (aim free)
         ~about:"What became of runs with a choice that nothing draws.";
       field "interrupted" bool (fun (t, _) -> t.interrupted)
         ~about:"By a limit of seconds, a signal, or the end of a process.";
       field "exit" Shared.exit (fun (_, exit) -> Exit_code.to_int exit);
       field "properties" (list answer) (fun (t, _) -> t.answers);
       field "left_out" (list left_out) (fun (t, _) -> t.left_out)
         ~about:"Checks of the model that ask for no probability and no mean, or about other runs.";
       field "diagnostics" Scc_runs.Diag_json.formats (fun (t, _) -> (t.source, t.diagnostics))
         ~about:"Warnings about the model and its files.";
     ])
