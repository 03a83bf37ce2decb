(* Casts and contact tests against brute force, by the million:

     dune exec --profile release test/references/long/casts.exe -- --random 1000000 --degenerate 100000 --seed 1

   These numbers are the defaults. The same seed gives the same cases; --group N runs one group of them again.
   Prints how many cases of each kind ended how, and every difference; ends with 1 when there is one. *)

open Scc_long

let () =
  let random = ref 1_000_000 and degenerate = ref 100_000 and seed = ref 1 and group = ref (-1) in
  Arg.parse
    [ ("--random", Arg.Set_int random, "N cases by chance, at least");
      ("--degenerate", Arg.Set_int degenerate, "N constructed cases, at least");
      ("--seed", Arg.Set_int seed, "N of the generator");
      ("--group", Arg.Set_int group, "N run only this group") ]
    (fun arg -> raise (Arg.Bad ("unexpected " ^ arg)))
    "casts [--random N] [--degenerate N] [--seed N] [--group N]";
  let total = !random + !degenerate in
  let shown = ref (-1) in
  let progress n =
    let percent = 100 * n / total in
    if percent > !shown then begin
      shown := percent;
      Printf.eprintf "\r%3d%%%!" (Int.min 100 percent)
    end
  in
  let progress = if Unix.isatty Unix.stderr then progress else ignore in
  let report =
    Run.run ~progress
      { random = !random; degenerate = !degenerate; seed = !seed;
        only = (if !group < 0 then None else Some !group);
        hulls = [ 10; 14; 14; 20; 36; 60 ] }
  in
  if Unix.isatty Unix.stderr then Printf.eprintf "\r    \r%!";
  Run.print report;
  if report.differences <> [] then exit 1
