open Cmdliner

let seed_conv =
  let parse s =
    match Int64.of_string_opt s with
    | Some seed -> Ok seed
    | None -> Error (`Msg (Printf.sprintf "`%s' is no integer of 64 bits" s))
  in
  Arg.conv ~docv:"SEED" (parse, fun ppf -> Format.fprintf ppf "%Ld")

let seed =
  Options.default seed_conv 0L [ "seed" ] ~docv:"SEED"
    "An integer. Run $(i,k) has the seed that is the output number $(i,k), from 0 on, of SplitMix64 from this \
     integer, and makes its choices by it as $(b,scc trace --choose random:) does. The runs are the same for any \
     $(b,--jobs) and on every machine."

let jobs =
  Options.default Options.processes 1 [ "j"; "jobs" ] ~docv:"J" "How many processes work at the runs."

let seconds =
  Options.maybe Check_options.seconds_conv [ "seconds" ] ~docv:"S"
    "Makes runs for at most $(docv) seconds of the clock. No default."

