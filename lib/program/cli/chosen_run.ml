open Scc_exact
open Scc_motion
open Scc_loading
open Scc_verdicts
open Scc_runs
open Cmdliner

type choose = First | Random of int64

type options = {
  schedule : string option;
  choose : choose;
  start : Sample.how option;
  steps : int option;
  time : Rat.t option;
}

type t = {
  loaded : Loaded.t;
  sampled : (string * Rat.t) list;
  policy : Replay.policy;
  limits : Replay.limits;
  is_cut : bool;
}

let model console o ~(given : Options.definitions) path =
  match o.schedule with
  | None ->
    let* model = Input.model console ~overrides:given.values ~narrowed:given.narrowed path in
    Ok (model, None)
  | Some file ->
    let* schedule = Scheduled.read console file in
    let* model = Scheduled.model console schedule ~given path in
    Ok (model, Some schedule)

(* The ordinary model of one start: the values of -D and of the schedule, and for what they leave open those that
   are sampled. *)
let at_start o (l : Loaded.t) =
  match o.start with
  | None ->
    let* () = Ordinary.at_point ~otherwise:"`--start simple` chooses them" l in
    Ok (l, [])
  | Some how -> (
      match Sample.values how l.model.ranges with
      | [] -> Ok (l, [])
      | values ->
        let* l = Loaded.at l values in
        Ok (l, values))

let policy o = function
  | Some s -> Replay.Scheduled s
  | None -> ( match o.choose with First -> Replay.First | Random seed -> Replay.Random seed)

(* A schedule is followed to its end unless a limit is asked for. *)
let limits o schedule : Replay.limits =
  let steps =
    match (o.steps, schedule, o.time) with
    | Some n, _, _ -> Some n
    | None, None, None -> Some Replay.default_steps
    | None, _, _ -> None
  in
  { steps; time = o.time; instant = Replay.default_instant }

let prepare console o ~given path =
  let* model, schedule = model console o ~given path in
  let* loaded, sampled = at_start o model in
  Console.report console loaded.warnings;
  let limits = limits o schedule in
  let is_cut = Option.is_none o.steps && Option.is_some limits.steps in
  Ok { loaded; sampled; policy = policy o schedule; limits; is_cut }

let each (l : Loaded.t) policy limits ~interrupted ~start ~leg =
  let before = ref l.declared and time = ref Rat.zero and rest = ref Rat.zero in
  let note : Replay.event -> unit = function
    | Start s ->
      before := s;
      start s
    | Step { taken; state; time = until; _ } ->
      let after = state () in
      leg { Course.label = taken.label; start = !time; before = !before; after };
      before := after;
      time := until
    | Instant i -> rest := i.offset
    | End _ -> ()
  in
  let* ending = Replay.run l.semantics l.declared policy limits ~interrupted note in
  Ok (!rest, ending)

let follow (l : Loaded.t) policy limits ~interrupted =
  let initial = ref l.declared and steps = ref [] in
  let start s = initial := s and leg (g : Course.leg) = steps := (g.label, g.after) :: !steps in
  let* rest, ending = each l policy limits ~interrupted ~start ~leg in
  Ok (Course.make l.semantics ~initial:!initial (List.rev !steps) ~rest, ending)

let finish console ?(is_cut = false) (l : Loaded.t) (result : (Replay.ending, Replay.failure) result) =
  let report d = Console.report console [ d ] in
  match result with
  | Ok Zeno ->
    Console.note console
      (Printf.sprintf "scc: stopped after %d transitions without time passing (Zeno behaviour)"
         Replay.default_instant);
    Exit_code.Stopped
  | Ok Open when is_cut ->
    Console.note console
      (Printf.sprintf
         "scc: the run is left after %d transitions, each draw is one; `--time` or `--steps` makes it longer"
         Replay.default_steps);
    Exit_code.Holds
  | Ok (Open | Quiescent | Broken_off) -> Exit_code.Holds
  | Error (Interrupted stop) ->
    Console.note console ("scc: " ^ Watch.reason stop);
    Exit_code.Stopped
  | Error (Refused d) ->
    report d;
    Exit_code.Invalid
  | Ok (Stuck f) | Error (Fault f) ->
    report (Replay.diagnostic l.model f);
    Exit_code.of_fault f.fault

(* {1 The command line} *)

let schedule =
  Options.maybe Arg.string [ "schedule" ] ~docv:"FILE"
    "Makes the choices of $(docv): a schedule, as $(b,scc check --witness) writes it, or a trace, whose schedule \
     is used. The run follows it to its end. An impossible choice is an error."

(* A word, or a seed; [seed] is that of a value which is not the word. *)
let seeded ~docv word ~plain ~random ~seed =
  let parse s =
    let n = String.length s in
    if String.equal s word then Ok plain
    else if n > 7 && String.equal (String.sub s 0 7) "random:" then
      match Int64.of_string_opt (String.sub s 7 (n - 7)) with
      | Some seed -> Ok (random seed)
      | None -> Error (`Msg "the seed is no integer of 64 bits")
    else Error (`Msg (Printf.sprintf "`%s' is neither `%s' nor `random:SEED'" s word))
  in
  let print ppf x =
    match seed x with
    | None -> Format.pp_print_string ppf word
    | Some seed -> Format.fprintf ppf "random:%Ld" seed
  in
  Arg.conv ~docv (parse, print)

let choose_conv : choose Arg.conv =
  let random seed = Random seed and seed = function First -> None | Random seed -> Some seed in
  seeded ~docv:"POLICY" "first" ~plain:First ~random ~seed

let start_conv : Sample.how Arg.conv =
  let random seed = Sample.Random seed and seed = function Sample.Simple -> None | Random seed -> Some seed in
  seeded ~docv:"START" "simple" ~plain:Sample.Simple ~random ~seed

let choose =
  Options.default choose_conv First [ "choose" ] ~docv:"POLICY"
    "How to choose between transitions: $(b,first), the first one, or $(b,random:SEED). Then draws and lots go \
     by their probabilities, and other transitions are equally likely, by the generator SplitMix64 from the \
     integer $(b,SEED): the same on every machine."

let start ~sampled =
  let doc =
    "Which start to use where parameters have ranges: $(b,simple), simple numbers within the ranges, or \
     $(b,random:SEED). The latter takes for each parameter one of the 1023 values that divide its range into \
     1024 equal parts, by the generator SplitMix64 from the integer $(b,SEED). Values that $(b,-D) or a schedule \
     gives are kept, and a range that $(b,-D) narrows is the one that is sampled. "
    ^ sampled
  in
  Arg.(value & opt (some start_conv) None & info [ "start" ] ~docv:"START" ~doc)

let steps =
  let doc =
    Printf.sprintf
      "Ends the run after $(docv) transitions; each draw and each lot is one. The default is %d when neither a \
       schedule nor $(b,--time) ends it." Replay.default_steps
  in
  Arg.(value & opt (some Options.transitions) None & info [ "steps" ] ~docv:"N" ~doc)

let time =
  Options.maybe (Options.not_negative "model time") [ "time" ] ~docv:"T"
    "Ends the run at the model time $(docv), between events if necessary; 0 is its first instant."

let options ~sampled =
  let make schedule choose start steps time = { schedule; choose; start; steps; time } in
  Term.(const make $ schedule $ choose $ start ~sampled $ steps $ time)
