open Scc_graph_search

type t = { watch : Watch.t; command : int; own : Watch.t Lazy.t; mutable ended : bool }

let start ?seconds ~memory ~jobs () =
  let words = Check_options.words_of memory in
  let own = lazy (Watch.start ~signals:false ~memory:(Int.max 1 (words / jobs)) ()) in
  { watch = Watch.start ?seconds ~memory:words (); command = Unix.getpid (); own; ended = false }

let watch t = t.watch

(* Where the system gives no process, the command makes the runs itself, by its own watch. It never makes [own], so
   that a process with one need not ask the system which it is. *)
let over t =
  if (not (Lazy.is_val t.own)) && Unix.getpid () = t.command then Watch.stop t.watch () = Some Limits.Memory
  else Option.is_some (Watch.stop (Lazy.force t.own) ())

let ended t = t.ended <- true
let stopped t = t.ended || Option.is_some (Watch.stop t.watch ())

let reason t =
  match Watch.stop t.watch () with
  | _ when Watch.interrupted t.watch () -> Watch.reason Interrupted
  | Some stop -> Watch.reason stop
  | None -> Watch.reason (if t.ended then Memory else Interrupted)
