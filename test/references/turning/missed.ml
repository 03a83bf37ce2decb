(* Casts of turning bodies against the subdivision of time of test/references/naive, by the hundred thousand:

     dune exec --profile release test/references/turning/missed.exe -- --random 100000 --grazing 10000 --seed 1

   These numbers are the defaults. The same seed gives the same cases; --from N begins with the N-th of each kind.
   Prints, for each kind, how many were checked, how many of them hit, in how many both agree, in how many the
   reference leaves open what happens, and what is wrong; ends with 1 when something is. *)

open Scc_turning
open Scc_rigid

let () =
  let random = ref 100_000 and grazing = ref 10_000 and seed = ref 1 and from = ref 0 in
  let hull = ref "" and reference = ref false and sweep = ref false and show = ref false and only = ref "" in
  Arg.parse
    [ ("--random", Arg.Set_int random, "N cases by chance; a tenth of them aligned, in addition");
      ("--grazing", Arg.Set_int grazing, "N cases that nearly touch, and as many at a peak");
      ("--seed", Arg.Set_int seed, "N of the generator");
      ("--from", Arg.Set_int from, "N number of the first case of each kind");
      ("--hull", Arg.Set_string hull, "FILE hulls, for one case in a hundred; a shape of test/data/geometry");
      ("--only", Arg.Set_string only, "KIND one kind alone, by the name in the table");
      ("--sweep", Arg.Set sweep, " the exact sweep instead of the cast: slow");
      ("--open", Arg.Set show, " show what is left open as well");
      ("--reference", Arg.Set reference, " the reference alone") ]
    (fun arg -> raise (Arg.Bad ("unexpected " ^ arg)))
    "missed [--random N] [--grazing N] [--seed N] [--from N] [--hull FILE]";
  let cast : Turning_check.cast =
    if !reference then fun _ _ ~span:_ ~grid:_ -> Cast.Never
    else if !sweep then Turning_check.by_sweep
    else fun a b -> Cast.first_time_of_contact a b
  in
  let all = Turning_check.tally () in
  let row name (t : Turning_check.tally) =
    Printf.printf "%-26s %8d %8d %8d %6d %7d %9d %11d\n%!" name t.checked t.hits t.agreed t.undecided t.missed
      t.spurious t.wrong_times
  in
  Printf.printf "%-26s %8s %8s %8s %6s %7s %9s %11s\n" "" "checked" "hits" "agreed" "open" "missed" "spurious"
    "wrong times";
  let group name kind shapes count =
    if count > 0 && (String.equal !only "" || String.equal !only name) then begin
      let start = Sys.time () in
      let t = Turning_check.tally () in
      let start_at = !from in
      let stop = start_at + count in
      let rec go at =
        if at < stop then begin
          let n = Int.min 100 (stop - at) in
          Turning_check.run cast t ~seed:!seed kind shapes ~from:at ~count:n;
          if Unix.isatty Unix.stderr then Printf.eprintf "\r%s %d%%%!" name (100 * (at + n - start_at) / count);
          go (at + n)
        end
      in
      go start_at;
      if Unix.isatty Unix.stderr then Printf.eprintf "\r                              \r%!";
      row name t;
      if !reference then Printf.printf "%.1f ms each\n" ((Sys.time () -. start) *. 1e3 /. float_of_int count)
      else List.iter (fun s -> Printf.printf "  WRONG: %s\n%!" s) t.complaints;
      if !show then List.iter (fun s -> Printf.printf "  open: %s\n%!" s) t.opened;
      all.checked <- all.checked + t.checked;
      all.hits <- all.hits + t.hits;
      all.agreed <- all.agreed + t.agreed;
      all.undecided <- all.undecided + t.undecided;
      all.missed <- all.missed + t.missed;
      all.spurious <- all.spurious + t.spurious;
      all.wrong_times <- all.wrong_times + t.wrong_times
    end
  in
  let hulls = if String.equal !hull "" then [||] else [| Turning_cases.read !hull |] in
  let share n = if Array.length hulls = 0 then 0 else n / 100 in
  group "by chance" Chance Turning_cases.small (!random - share !random);
  group "by chance, hulls" Chance hulls (share !random);
  group "aligned" Aligned [| Turning_cases.cube |] (!random / 10);
  group "at a peak" Peak Turning_cases.small !grazing;
  group "nearly grazing" Grazing Turning_cases.small (!grazing - share !grazing);
  group "nearly grazing, hulls" Grazing hulls (share !grazing);
  row "all" all;
  if not !reference && not (Turning_check.right all) then exit 1
