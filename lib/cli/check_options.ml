open Scc_exact
open Scc_verify
open Cmdliner

type bounds = {
  depth : int option;
  time : Rat.t option;
  states : int option;
  seconds : float option;
  memory : int option;
}

let default_states = 200_000
let default_memory = 3072
let words_of_mib mib = mib * 1024 * 1024 / (Sys.word_size / 8)

let options ?(now = Unix.gettimeofday) b ~interrupted ~progress : Check.options =
  let given = function Some x -> Bounds.Given x | None -> Bounds.Unbounded in
  let or_default default = function Some x -> Bounds.Given x | None -> Bounds.Default default in
  let bounds =
    {
      Bounds.default with
      depth = given b.depth;
      time = given b.time;
      states = or_default default_states b.states;
      seconds = given b.seconds;
      memory = or_default (words_of_mib default_memory) (Option.map words_of_mib b.memory);
    }
  in
  { Check.default with bounds; surroundings = { now; interrupted; progress; attempt = Interrupt.attempt } }

let positive_int what =
  let parse s =
    match int_of_string_opt s with
    | Some n when n > 0 && n < 1 lsl 40 -> Ok n
    | _ -> Error (`Msg (Printf.sprintf "`%s' is no positive number of %s" s what))
  in
  Arg.conv ~docv:"N" (parse, Format.pp_print_int)

let natural =
  let parse s =
    match int_of_string_opt s with
    | Some n when n >= 0 -> Ok n
    | _ -> Error (`Msg (Printf.sprintf "`%s' is no number of transitions" s))
  in
  Arg.conv ~docv:"N" (parse, Format.pp_print_int)

let duration =
  let parse s =
    match Arg.conv_parser Options.rational s with
    | Ok t when Rat.sign t < 0 -> Error (`Msg "a bound of time is not negative")
    | result -> result
  in
  Arg.conv ~docv:"T" (parse, Arg.conv_printer Options.rational)

let seconds_conv =
  let parse s =
    match float_of_string_opt s with
    | Some x when x > 0. && x < infinity -> Ok x
    | _ -> Error (`Msg (Printf.sprintf "`%s' is no positive number of seconds" s))
  in
  Arg.conv ~docv:"S" (parse, fun ppf x -> Format.fprintf ppf "%g" x)

let docs = "BOUNDS"

let depth =
  let doc = "Expands only states that $(docv) or fewer transitions lead to. No default." in
  Arg.(value & opt (some natural) None & info [ "depth" ] ~docv:"N" ~doc ~docs)

let time =
  let doc = "Expands only states that can be reached by the model time $(docv). No default." in
  Arg.(value & opt (some duration) None & info [ "time" ] ~docv:"T" ~doc ~docs)

let states =
  let doc = Printf.sprintf "Keeps at most $(docv) states. The default is %d." default_states in
  Arg.(value & opt (some (positive_int "states")) None & info [ "states" ] ~docv:"N" ~doc ~docs)

let seconds =
  let doc = "Explores for at most $(docv) seconds of the clock. No default." in
  Arg.(value & opt (some seconds_conv) None & info [ "seconds" ] ~docv:"S" ~doc ~docs)

let memory =
  let doc = Printf.sprintf "Uses at most about $(docv) MiB of memory. The default is %d." default_memory in
  Arg.(value & opt (some (positive_int "MiB")) None & info [ "memory" ] ~docv:"N" ~doc ~docs)

let bounds =
  let make depth time states seconds memory = { depth; time; states; seconds; memory } in
  Term.(const make $ depth $ time $ states $ seconds $ memory)
