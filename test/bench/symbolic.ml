(* Sets of runs: how much processor time what has a bar takes in lib/verification/symbolic, and how many zones; of
   a hundred thousand of them, how much of the heap as well.

   dune exec --profile release test/bench/symbolic.exe [NAME ...] *)

open Scc_calculus
open Scc_state_space
open Scc_symbolic
open Scc_verify
module Loaded = Scc_loading.Loaded

let models = "specs/models"

let cube =
  {|shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
|}

(* A pocket with a seat on each side, and a ligand on the way to each, which arrive in any order. *)
let race n =
  let ways =
    [ ("right", 1, 0, 0); ("left", -1, 0, 0); ("back", 0, 1, 0); ("front", 0, -1, 0); ("top", 0, 0, 1) ]
  in
  let ways = List.filteri (fun i _ -> i < n) ways in
  let ligand i (_, x, y, z) =
    let along c = match c with 0 -> "0" | c -> Printf.sprintf "%d * (4 + s%d)" c i in
    Printf.sprintf "process l%d = Cube mass 1 velocity (%d,%d,%d) at translate (%s, %s, %s) [Ligand]\n" i (-x) (-y)
      (-z) (along x) (along y) (along z)
  in
  let parameter i _ = Printf.sprintf "param s%d in [0, 6]\n" i in
  let others = List.init (n - 1) (fun i -> Printf.sprintf "bound(pocket, l%d)" (i + 1)) in
  "model race\n" ^ cube
  ^ String.concat "" (List.mapi parameter ways)
  ^ {|behaviour Pocket on Cube = <a, {right, left, back, front, top, bottom}>. Pocket
behaviour Ligand on Cube = <~a, {right, left, back, front, top, bottom}>. nil
fixed pocket = Cube [Pocket]
|}
  ^ String.concat "" (List.mapi ligand ways)
  ^ Printf.sprintf "check first : possibly (bound(pocket, l0) and not (%s))\n" (String.concat " or " others)

(* Two balls, eight walls of a flat box, and where they start is not known in two dimensions. *)
let box =
  "model box\n" ^ cube
  ^ {|param a in [0, 1]
param b in [0, 1]
param c in [0, 1]
param d in [0, 1]
fixed west  = Cube scaled (1, 8, 1) at translate (-7, 0, 0)
fixed east  = Cube scaled (1, 8, 1) at translate (7, 0, 0)
fixed south = Cube scaled (6, 1, 1) at translate (0, -7, 0)
fixed north = Cube scaled (6, 1, 1) at translate (0, 7, 0)
process p = Cube mass 1 velocity (1, 1/2, 0) at translate (-4 + a, -1 + b, 0) [nil]
process q = Cube mass 1 velocity (-1/2, -1, 0) at translate (c, 3 + d, 0) [nil]
check corner : possibly (x(p) > 4 and y(q) > 3) within 16
|}

let unit_ranges n = String.concat "" (List.init n (Printf.sprintf "param s%d in [0, 1]\n"))

(* A row of bodies, of each of which the place is known but for one number. *)
let row n =
  let body i =
    Printf.sprintf "process p%d = Cube mass 1 velocity (0,0,0) at translate (%d + s%d, 0, 0) [nil]\n" i (10 * i) i
  in
  "model row\n" ^ cube ^ unit_ranges n
  ^ String.concat "" (List.init n body)
  ^ "process q = Cube mass 1 velocity (1,0,0) at translate (-4, 0, 0) [nil]\n\
     check meets : always not touching(q, p0) within 5/2\n"

(* A body that is on its way since a sum of times that are not known. *)
let sum n =
  let all = String.concat " + " (List.init n (Printf.sprintf "s%d")) in
  "model sum\n" ^ cube ^ unit_ranges n
  ^ Printf.sprintf "process p = Cube mass 1 velocity (1,0,0) at translate (%s, 0, 0) [nil]\n" all
  ^ Printf.sprintf "check far : possibly x(p) > %d/3 within 0\n" n

(* Each may break at any time, and what becomes of its halves depends on when: all that is ordered in any way. *)
let dimers n =
  let dimer i =
    Printf.sprintf
      "process d%d = p%d : Cube mass 1 at translate (0, %d, 0) [One]\n  <hold, {p%d.right, q%d.left}>\n  \
       q%d : Cube mass 1 at translate (2, %d, 0) [Other]\n"
      i i (10 * i) i i i (10 * i)
  in
  "model dimers\nsplit_step any\n" ^ cube
  ^ {|behaviour One on Cube = omega(hold, {right}). eps(1). nil
behaviour Other on Cube = omega(hold, {left}). eps(2). nil
|}
  ^ String.concat "" (List.init n dimer)
  ^ "check still : always x(p0) = 0\n"

let replaced changes text =
  let replace text (old, new_) = Str.global_replace (Str.regexp_string old) new_ text in
  List.fold_left replace text changes

let window = replaced [ ("param grid = 1\nsplit_step grid\n", "split_step any\n") ]

let hexokinase =
  replaced
    [
      ("param atp_arrives = 2", "param atp_arrives in [0, 10]");
      ("param glucose_arrives = 2", "param glucose_arrives in [0, 10]");
      ("split_step 1\n", "split_step any\n");
      ("check surely", "// check surely");
    ]

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

(* What has a bar of zones as well. *)
let zones_bars = [ ("window", 50) ]

let most_zones = 100_000
let heap_bar = 2048

let bars =
  let all = Reduction.all and none = [] in
  [
    ("window", 0.02, all, fun () -> window (read (Filename.concat models "window.sc")));
    ("race of 3", 0.1, all, fun () -> race 3);
    ("race of 4", 1., all, fun () -> race 4);
    ("race of 5", 5., all, fun () -> race 5);
    ("two balls", 2., all, fun () -> box);
    ("row of 100", 1., all, fun () -> row 100);
    ("sum of 10", 1., all, fun () -> sum 10);
    ("hexokinase", 5., all, fun () -> hexokinase (read (Filename.concat models "hexokinase.sc")));
    ("six dimers", 60., none, fun () -> dimers 6);
    ("2 dimers", 1., none, fun () -> dimers 2);
    ("2, sliced", 0.1, all, fun () -> dimers 2);
    ("3 dimers", 1., none, fun () -> dimers 3);
    ("3, sliced", 0.1, all, fun () -> dimers 3);
    ("4 dimers", 5., none, fun () -> dimers 4);
    ("4, sliced", 0.1, all, fun () -> dimers 4);
    ("40, sliced", 1., all, fun () -> dimers 40);
  ]

let load name text =
  match Loaded.load ~read_file:(fun _ -> Error "no file") ~overrides:[] (Scc_base.Source.make ~name text) with
  | Ok l -> l
  | Error ds -> failwith (String.concat "\n" (List.map (fun (d : Scc_base.Diag.t) -> d.message) ds))

let ask text ~name options =
  let l = load name text in
  let u = match l.uncertain with Some u -> u | None -> Start.known l.model l.declared in
  let start = Sys.time () in
  let answer = Zone_check.run options l.semantics u ~declared:l.declared ~exactly:true ~premises:[] l.checks in
  let probabilities =
    match answer with Ok report -> List.map Scc_regions.Where.probability report.where | Error _ -> []
  in
  (l, answer, probabilities, Sys.time () -. start)

let judged within = if within then "within" else "BEYOND"

let measure (name, bar, reductions, text) =
  let options = { Check.default with reductions; bounds = { Bounds.default with states = Given most_zones } } in
  match ask (text ()) ~name options with
  | _, Error _, _, _ -> failwith (name ^ ": its start is not well-formed")
  | l, Ok report, probabilities, time ->
    Printf.printf "%-12s %8.3f s of %5.2f  %s %6d zones, %6d edges, %s; %d parameters\n%!" name time bar
      (judged (time <= bar))
      report.stats.states report.stats.transitions
      (if report.stats.complete then "complete" else "not complete")
      (Array.length l.model.Model.ranges);
    List.iter2
      (fun (c : Scc_property.Property.check) (probability : Scc_regions.Where.probability) ->
         let p =
           match probability with
           | Exactly p -> Scc_exact.Rat.to_string p
           | Between (a, b) -> Scc_exact.(Rat.to_string a ^ " to " ^ Rat.to_string b)
           | Not_computed -> "not computed"
         in
         Printf.printf "    %s: probability %s\n%!" c.name p)
      l.checks probabilities;
    let judge_zones bar =
      Printf.printf "    zones: %d of %d  %s\n%!" report.stats.states bar (judged (report.stats.states < bar))
    in
    Option.iter judge_zones (List.assoc_opt name zones_bars);
    if report.stats.states >= most_zones then
      let mebibytes = (Gc.quick_stat ()).top_heap_words * (Sys.word_size / 8) / 1_048_576 in
      Printf.printf "    heap: %d MiB of %d  %s\n%!" mebibytes heap_bar (judged (mebibytes <= heap_bar))

(* {1 The cases by hand} *)

let cases_bar = 0.1

(* Those of the conformance suite that have an answer, the ones of the design among them: the slowest. *)
let measure_cases () =
  let member = Yojson.Basic.Util.member and text = Yojson.Basic.Util.to_string in
  let of_case case =
    match (member "method" case, member "params" case) with
    | `String "model.check", params when member "error" (member "expect" case) = `Null ->
      let l, _, _, time = ask (text (member "text" params)) ~name:"case" Check.default in
      if Zone_check.is_for l.model ~declared:l.declared then Some (time, text (member "id" case)) else None
    | _ -> None
  in
  let suite = Yojson.Basic.from_string (read "specs/conformance/rules/Zones/cases.json") in
  let times = List.filter_map of_case (Yojson.Basic.Util.to_list (member "cases" suite)) in
  let slowest = List.fold_left Stdlib.max (0., "") times in
  Printf.printf "%-12s %8.3f s of %5.2f  %s the slowest of %d, %s\n%!" "cases" (fst slowest) cases_bar
    (judged (fst slowest <= cases_bar))
    (List.length times) (snd slowest)

let () =
  let asked = List.tl (Array.to_list Sys.argv) in
  let is_asked name = asked = [] || List.mem name asked in
  if is_asked "cases" then measure_cases ();
  List.iter (fun ((name, _, _, _) as bar) -> if is_asked name then measure bar) bars
