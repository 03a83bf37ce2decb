open Scc_base
open Scc_exact
open Scc_property
open Scc_loading
open Scc_estimate
open Cmdliner

type t = {
  runs : int option;
  most : int option;
  confidence : Rat.t;
  width : Rat.t option;
  free : Sample.free;
  steps : int option;
  until : Rat.t option;
  seed : int64;
  normal : bool;
}

(* {1 What is estimated} *)

(* Everything that can be estimated, if nothing is named; what is named has to be. *)
let paths (l : Loaded.t) asked ~by_name =
  let one (found, left) (c : Property.check) =
    match Path.of_check ~from:l.declared (Scc_semantics.Semantics.model l.semantics) c with
    | Ok path -> Ok (path :: found, left)
    | Error why -> if by_name then Error (Levels.refused c why) else Ok (found, (c, why) :: left)
  in
  let* found, left =
    List.fold_left (fun acc c -> let* acc = acc in one acc c) (Ok ([], [])) asked
  in
  let is_about_chance ((c : Property.check), _) =
    match c.asked with
    | How_likely _ | Expected _ -> true
    | Whether -> Formula.asks_probability c.formula
  in
  match (found, left) with
  | [], [] when by_name ->
    Error
      [
        Diag.error Code.wrong_kind Span.command_line "the checks that are named have no members here"
          ~hint:"the loops that declare them are empty";
      ]
  | [], _ when List.exists is_about_chance left ->
    Error (List.concat_map (fun (c, why) -> Levels.refused c why) (List.filter is_about_chance (List.rev left)))
  | [], _ ->
    Error
      [
        Diag.error Code.type_mismatch
          (Span.of_file (Source.name l.source))
          "no check of the model asks for a probability or a mean"
          ~hint:"`--property 'P = ? [ eventually f ]'` asks";
      ]
  | found, left -> Ok (List.rev found, List.rev_map (fun ((c : Property.check), why) -> (c.name, why)) left)

let default_most = 10_000
let default_width = Rat.make Z.one (Z.of_int 20)

let aim t =
  let most = Option.value t.most ~default:default_most and width = Option.value t.width ~default:default_width in
  let size = match t.runs with Some n -> Estimation.Exactly n | None -> At_most most in
  { Estimation.confidence = t.confidence; width; size; free = t.free; normal = t.normal }

let plan t (l : Loaded.t) paths =
  { Sample.semantics = l.semantics; declared = l.declared; paths; free = t.free; steps = t.steps; until = t.until }

(* {1 The command line} *)

let count = Options.integer ~least:1 "positive number of runs"

let runs =
  Options.maybe count [ "runs" ] ~docv:"N"
    "Makes $(docv) runs, and evaluates once: the intervals are narrower than after as many runs by \
     $(b,--width). With $(b,--levels), makes $(docv) repetitions; the default is 100."

let most =
  Options.maybe count [ "most" ] ~docv:"N"
    "Makes at most $(docv) runs; the default is 10000. Not with $(b,--runs)."

let default_confidence = Rat.make (Z.of_int 99) (Z.of_int 100)

let confidence =
  Options.default (Options.positive "confidence") default_confidence [ "confidence" ] ~docv:"C"
    "An interval misses the number, or an answer is wrong, with a probability of at most 1 less $(docv), for each \
     property."

let width =
  Options.maybe (Options.positive "width") [ "width" ] ~docv:"W"
    "Makes runs until the interval of a probability is at most $(docv) wide, and that of a mean at most this \
     share of the mean; of a comparison, until it is decided. The default is 1/20. Not with $(b,--runs)."

let free =
  let ways = Arg.enum [ ("apart", Sample.Apart); ("evenly", Sample.Evenly) ] in
  Options.default ways Sample.Apart [ "free" ] ~docv:"HOW"
    "The treatment of a run where several things are possible and none of them is drawn. With $(b,apart) the run \
     stops there. What is still unknown then counts for no at the lower end of the interval, and for yes at the \
     upper end. So the interval contains the least and the greatest probability. With $(b,evenly) each \
     possibility has the same probability; the result is valid only for these choices."

let steps =
  Options.maybe Options.transitions [ "steps" ] ~docv:"N"
    "Leaves a run after $(docv) transitions; the draws and lots of one instant count as one. The default is \
     10000 if neither the formulas nor $(b,--until) end the run at a time, and none otherwise."

let until =
  Options.maybe (Options.not_negative "model time") [ "until" ] ~docv:"TIME"
    "Stops a run at the model time $(docv), if not all is decided by then; 0 is its first instant. A number at \
     $(docv) is decided only when time has passed."

let normal =
  Options.flag [ "normal" ]
    "Gives a mean without a proved interval an approximate one, of the normal distribution, and says so. It needs \
     30 runs with another value than the most frequent one."

let least_miss_if_normal = Rat.div Normal_mean.least_miss (Rat.make Z.one (Z.pow (Z.of_int 10) 8))

let least_width = Rat.make Z.one (Z.of_int 10_000)

let conflict t =
  if Rat.compare t.confidence Rat.one >= 0 then Some "a confidence is below 1"
  else if Option.is_some t.runs && (Option.is_some t.most || Option.is_some t.width) then
    Some "--runs cannot be combined with --most or --width: it makes so many runs, whatever they tell"
  else if t.normal && Rat.compare (Rat.sub Rat.one t.confidence) least_miss_if_normal < 0 then
    Some "--normal takes a confidence of at most 1 - 10^-12"
  else if Option.fold ~none:false ~some:(fun w -> Rat.compare w least_width < 0) t.width then
    Some "a width is at least 1/10000"
  else None

let described t =
  let some name text = Option.fold ~none:[] ~some:(fun x -> [ (name, text x) ]) in
  let aim = aim t in
  (match aim.size with
   | Exactly n -> [ ("runs", string_of_int n) ]
   | At_most n -> [ ("most", string_of_int n); ("width", Rat.to_string aim.width) ])
  @ [
    ("confidence", Rat.to_string t.confidence); ("seed", Int64.to_string t.seed);
    ("free", match t.free with Apart -> "apart" | Evenly -> "evenly");
  ]
  @ some "steps" string_of_int t.steps
  @ some "until" Rat.to_string t.until
  @ if t.normal then [ ("normal", "true") ] else []

let given t =
  let some name option = if Option.is_some option then [ name ] else [] in
  let if_ name is = if is then [ name ] else [] in
  List.concat
    [
      some "--runs" t.runs; some "--most" t.most; some "--width" t.width; some "--steps" t.steps;
      some "--until" t.until; if_ "--normal" t.normal; if_ "--free" (t.free = Sample.Evenly);
      if_ "--seed" (not (Int64.equal t.seed 0L));
      if_ "--confidence" (not (Rat.equal t.confidence default_confidence));
    ]

let term =
  let make runs most confidence width free steps until seed normal =
    let t = { runs; most; confidence; width; free; steps; until; seed; normal } in
    match conflict t with Some text -> Error text | None -> Ok t
  in
  Term.(
    term_result' ~usage:true
      (const make $ runs $ most $ confidence $ width $ free $ steps $ until $ Run_options.seed $ normal))
