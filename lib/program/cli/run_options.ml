open Cmdliner

let seed_conv =
  let parse s =
    match Int64.of_string_opt s with
    | Some seed -> Ok seed
    | None -> Error (`Msg (Printf.sprintf "`%s' is no integer of 64 bits" s))
  in
  Arg.conv ~docv:"SEED" (parse, fun ppf -> Format.fprintf ppf "%Ld")

let seed =
  let doc =
    "An integer. Run $(i,k) has the seed that is the output number $(i,k), from 0 on, of SplitMix64 from this \
     integer, and makes its choices by it as $(b,scc trace --choose random:) does. The runs are the same for any \
     $(b,--jobs) and on every machine."
  in
  Arg.(value & opt seed_conv 0L & info [ "seed" ] ~docv:"SEED" ~doc)

let jobs =
  let doc = "How many processes work at the runs." in
  Arg.(
    value
    & opt (Options.integer ~least:1 ~most:1024 "number of processes from 1 to 1024") 1
    & info [ "j"; "jobs" ] ~docv:"J" ~doc)

let seconds =
  let doc = "Makes runs for at most $(docv) seconds of the clock. No default." in
  Arg.(value & opt (some Check_options.seconds_conv) None & info [ "seconds" ] ~docv:"S" ~doc)

