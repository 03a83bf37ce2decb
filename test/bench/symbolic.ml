(* Sets of runs: how much processor time the bars of lib/symbolic take, and how many zones.

   dune exec --profile release test/bench/symbolic.exe [NAME ...] *)

open Scc_calculus
open Scc_symbolic
open Scc_verify
module Loaded = Scc_session.Loaded

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
  let body i = Printf.sprintf "process p%d = Cube mass 1 velocity (0,0,0) at translate (%d + s%d, 0, 0) [nil]\n" i (10 * i) i in
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

let hexokinase =
  let replace text (old, new_) = Str.global_replace (Str.regexp_string old) new_ text in
  fun text ->
    List.fold_left replace text
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

let bars =
  [
    ("window", 0.02, fun () -> read (Filename.concat models "window.sc"));
    ("race of 3", 0.1, fun () -> race 3);
    ("race of 4", 1., fun () -> race 4);
    ("race of 5", 5., fun () -> race 5);
    ("two balls", 2., fun () -> box);
    ("row of 100", 1., fun () -> row 100);
    ("sum of 10", 1., fun () -> sum 10);
    ("hexokinase", 5., fun () -> hexokinase (read (Filename.concat models "hexokinase.sc")));
  ]

let load name text =
  match Loaded.load ~read_file:(fun _ -> Error "no file") ~overrides:[] (Scc_base.Source.make ~name text) with
  | Ok l -> l
  | Error ds -> failwith (String.concat "\n" (List.map (fun (d : Scc_base.Diag.t) -> d.message) ds))

let measure (name, bar, text) =
  let l = load name (text ()) in
  let u = match l.uncertain with Some u -> u | None -> Start.known l.model l.declared in
  let start = Sys.time () in
  match Zone_check.run Check.default l.semantics u ~declared:l.declared ~exactly:true l.checks with
  | Error _ -> failwith (name ^ ": its start is not well-formed")
  | Ok report ->
    let probabilities = List.map Scc_where.Where.probability report.where in
    let time = Sys.time () -. start in
    Printf.printf "%-12s %8.3f s of %5.2f  %s %6d zones, %6d edges, %s; %d parameters\n%!" name time bar
      (if time <= bar then "within" else "BEYOND")
      report.stats.states report.stats.transitions
      (if report.stats.complete then "complete" else "not complete")
      (Array.length l.model.Model.ranges);
    List.iter2
      (fun (c : Scc_property.Property.check) (probability : Scc_where.Where.probability) ->
         let p =
           match probability with
           | Exactly p -> Scc_exact.Rat.to_string p
           | Between (a, b) -> Scc_exact.(Rat.to_string a ^ " to " ^ Rat.to_string b)
           | Not_computed -> "not computed"
         in
         Printf.printf "    %s: probability %s\n%!" c.name p)
      l.checks probabilities

let () =
  let asked = List.tl (Array.to_list Sys.argv) in
  List.iter (fun ((name, _, _) as bar) -> if asked = [] || List.mem name asked then measure bar) bars
