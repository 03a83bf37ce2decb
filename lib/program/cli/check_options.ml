open Scc_base
open Scc_exact
open Scc_verify
open Scc_verdicts
open Cmdliner

let default_states = 200_000
let default_mib = 3072

let words_of ?(jobs = 1) memory = Option.value memory ~default:(Memory.words_of_mib default_mib / jobs)
let words ?jobs (budget : Budget.t) = words_of ?jobs budget.memory

let defaults ?jobs budget : Budget.defaults =
  let memory = words ?jobs budget in
  { states = default_states; memory; room = Footprint.room_below memory }

let options ?jobs ?attempt watch budget ~progress : Setup.t =
  let attempt = Option.value attempt ~default:(Watch.attempt watch) in
  {
    Setup.default with
    bounds = Budget.bounds (defaults ?jobs budget) budget;
    surroundings = Watch.surroundings watch ~progress ~attempt;
  }

let watch ?signals ?jobs (budget : Budget.t) =
  Watch.start ?signals ?seconds:budget.seconds ~memory:(words ?jobs budget) ()

let starting ?attempt console watch (budget : Budget.t) =
  Console.phase console "beginning to explore";
  options ?attempt watch budget ~progress:(Progress.show console budget)

let positive what = Options.integer ~least:1 ~most:((1 lsl 40) - 1) ("positive number of " ^ what)

let seconds_conv =
  let number s =
    match Arg.conv_parser Options.rational s with
    | Ok x -> Some (Rat.to_float x)
    | Error _ -> float_of_string_opt s
  in
  let parse s =
    match number s with
    | Some x when x > 0. && x < infinity -> Ok x
    | Some _ | None -> Error (`Msg (Printf.sprintf "`%s' is no positive number of seconds" s))
  in
  Arg.conv ~docv:"S" (parse, fun ppf x -> Format.fprintf ppf "%g" x)

let docs = "BOUNDS"

let depth =
  Options.maybe Options.transitions [ "depth" ] ~docv:"N" ~docs
    "Expands only states that $(docv) or fewer transitions lead to. No default."

let time =
  Options.maybe (Options.not_negative "model time") [ "time" ] ~docv:"T" ~docs
    "Expands only states that can be reached by the model time $(docv); 0 is the first instant. No default."

let states =
  Options.maybe (positive "states") [ "states" ] ~docv:"N" ~docs
    (Printf.sprintf "Keeps at most $(docv) states. The default is %d." default_states)

let seconds =
  Options.maybe seconds_conv [ "seconds" ] ~docv:"S" ~docs
    "Explores for at most $(docv) seconds of the clock. No default."

let memory ?docs () =
  let doc =
    Printf.sprintf
      "Uses at most about $(docv) MiB of memory. The default is %d. If the system limits this process \
       ($(b,ulimit -v), $(b,ulimit -d)), the default is no more than about half of what is left when the program \
       has started."
      default_mib
  in
  let mib = Arg.(value & opt (some (positive "MiB")) None & info [ "memory" ] ~docv:"N" ~doc ?docs) in
  Term.(const (Option.map Memory.words_of_mib) $ mib)

let most_bits = Scc_calculus.Law.longest

let bits =
  let doc =
    "Expands only states whose numbers all have at most $(docv) bits, numerator and denominator together. The \
     default is 100000."
  in
  let number = Options.integer ~least:1 ~most:most_bits (Printf.sprintf "number of bits from 1 to %d" most_bits) in
  Arg.(value & opt (some number) None & info [ "bits" ] ~docv:"N" ~doc ~docs)

let budget =
  let make depth time states seconds memory bits =
    { Budget.depth; time; states; seconds; memory; bits }
  in
  Term.(const make $ depth $ time $ states $ seconds $ memory ~docs () $ bits)
