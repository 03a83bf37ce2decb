open Scc_exact
module Table = Map.Make (String)

type plan = { random : int; degenerate : int; seed : int; only : int option; hulls : int list }

type report = {
  counts : ((string * string) * int) list;
  by_chance : int;
  constructed : int;
  groups : int;
  checked_slowly : int;
  differences : string list;
}

type tally = {
  mutable table : int Table.t Table.t;
  mutable chance : int;
  mutable built : int;
  mutable slow : int;
  mutable found : string list;
}

let count tally kind outcome =
  let row = Option.value ~default:Table.empty (Table.find_opt kind tally.table) in
  let add n = Some (1 + Option.value ~default:0 n) in
  tally.table <- Table.add kind (Table.update outcome add row) tally.table

(* The bodies of a group are prepared once: the more axes they have, the more cases they are used for. *)
let cases_of_group pair = if Check.size pair > 150 then 300 else 60

let corners (b : Shapes.body) = Shapes.corners b.shape

let describe plan group index pair (c : Aim.case) what =
  Printf.sprintf
    "%s\n  in case %d of group %d (the same arguments and --group %d): %s\n%s\n  offset %s\n  velocity %s" what
    index group group c.kind (Check.show pair) (Vec.to_string c.r) (Vec.to_string c.w)
  ^ Printf.sprintf "\n  seed %d" plan.seed

let run_group plan tally shapes group =
  let g = Rng.make [ plan.seed; group ] in
  let first, second = Shapes.pair shapes g in
  let few_corners = corners first + corners second <= 16 in
  let pair = Check.group first second in
  let rec go index =
    if index < cases_of_group pair then begin
      let degenerate = Rng.below g (plan.random + plan.degenerate) < plan.degenerate in
      let c = if degenerate then Aim.degenerate g (Check.aim pair) else Aim.random g (Check.aim pair) in
      let once n = Rng.chance g n in
      let swapped = once 4 in
      let fresh = once (if few_corners then 16 else 100) in
      let all_axes = once 50 in
      let naive = once (if degenerate then 200 else 1000) && few_corners in
      match Check.case pair { swapped; fresh; all_axes; naive } c with
      | outcome ->
        count tally c.kind outcome;
        if degenerate then tally.built <- tally.built + 1 else tally.chance <- tally.chance + 1;
        if naive then tally.slow <- tally.slow + 1;
        go (index + 1)
      | exception Check.Differs what ->
        tally.found <- describe plan group index pair c what :: tally.found
      | exception ((Out_of_memory | Sys.Break) as e) -> raise e
      | exception e ->
        tally.found <- describe plan group index pair c (Printexc.to_string e) :: tally.found
    end
  in
  go 0

let run ?(progress = ignore) plan =
  let shapes = Shapes.make (Rng.make [ plan.seed ]) ~hulls:plan.hulls in
  let tally = { table = Table.empty; chance = 0; built = 0; slow = 0; found = [] } in
  let rec go group =
    let done_ = tally.chance >= plan.random && tally.built >= plan.degenerate in
    if done_ || List.length tally.found >= 10 then group
    else begin
      run_group plan tally shapes group;
      progress (tally.chance + tally.built);
      go (group + 1)
    end
  in
  let groups = match plan.only with Some g -> run_group plan tally shapes g; 1 | None -> go 0 in
  let row (kind, outcomes) = List.map (fun (o, n) -> ((kind, o), n)) (Table.bindings outcomes) in
  { counts = List.concat_map row (Table.bindings tally.table);
    by_chance = tally.chance;
    constructed = tally.built;
    groups;
    checked_slowly = tally.slow;
    differences = List.rev tally.found }

let print report =
  let kinds = List.sort_uniq String.compare (List.map (fun ((k, _), _) -> k) report.counts) in
  let line kind =
    let of_kind = List.filter (fun ((k, _), _) -> String.equal k kind) report.counts in
    let total = List.fold_left (fun s (_, n) -> s + n) 0 of_kind in
    let outcomes = List.map (fun ((_, o), n) -> Printf.sprintf "%s %d" o n) of_kind in
    Printf.printf "%-42s %7d: %s\n" kind total (String.concat ", " outcomes)
  in
  List.iter line kinds;
  Printf.printf
    "%d random and %d degenerate cases in %d pairs of bodies; %d of them also by the slow brute force\n"
    report.by_chance report.constructed report.groups report.checked_slowly;
  List.iter (fun d -> Printf.printf "DIFFERENCE: %s\n" d) report.differences;
  Printf.printf "%d differences\n" (List.length report.differences)
