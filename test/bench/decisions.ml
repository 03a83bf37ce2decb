(* Markov decision processes of about 10^6 states, made alike each time, and solved by Scc_chance; test/bench/mdp
   gives the same to Storm.

     decisions.exe KIND [--states N] [--drn FILE] [--exact]

   KIND is one of those of [kinds], below. The process and its questions are told by lines of fields with tabs
   between them: "process", states, choices and branches; for each question "question", what Storm is asked,
   seconds of processor time and sweeps; and after it "value", a state, its lower end and its upper end, for
   each of some states that are spread over all. Time is what solving takes for all states, from the finished
   process on: the graph, the equations, and the intervals, which are to be as wide as 10^-6 of their lower ends
   at most. *)

open Scc_exact
open Scc_chance

let rat n d = Rat.make (Z.of_int n) (Z.of_int d)

(* {1 Processes} *)

(* What the labels say of a state. *)
type place = Goal | Other_end | Inside

(* A state is a list of choices, each of targets and weights. *)
type kind = {
  states : int;
  place : int -> place;
  choices : int -> (int * int) list list;  (** of a state inside; a state of an end stays there *)
  timed : bool;  (** whether the time until an end is asked for as well; each choice takes 1 *)
}

(* A walker on a grid, whose sides left and right are the ends, and whose other sides turn back. [moves] are the
   weights of left, right, up and down in each choice. *)
let walk ~width ~height ~moves ~timed =
  let at x y = (Int.max 0 (Int.min (height - 1) y) * width) + x in
  let choice x y (left, right, up, down) =
    [ (at (x - 1) y, left); (at (x + 1) y, right); (at x (y - 1), up); (at x (y + 1), down) ]
  in
  {
    states = width * height;
    place =
      (fun s ->
         let x = s mod width in
         if x = 0 then Other_end else if x = width - 1 then Goal else Inside);
    choices =
      (fun s ->
         let x = s mod width and y = s / width in
         List.map (choice x y) (moves x y));
    timed;
  }

(* Gambler's ruin on a square: the walker drifts to the right, and may drift less in some states. *)
let grid n =
  let side = int_of_float (sqrt (float_of_int n)) in
  let moves x y = (2, 4, 2, 2) :: (if (x + (3 * y)) mod 5 = 0 then [ (3, 4, 2, 1) ] else []) in
  walk ~width:side ~height:side ~moves ~timed:false

(* A fair game in a narrow and long street, with choices that are unfair a little: the walker takes long. *)
let street n =
  let width = 24 in
  let moves x y =
    (1, 1, 1, 1) :: (if (x + (3 * y)) mod 4 = 0 then [ (10, 9, 9, 10); (9, 10, 10, 9) ] else [])
  in
  walk ~width ~height:(n / width) ~moves ~timed:true

(* Numbers that are anyhow, the same for the same [key]. *)
let scrambled key below =
  let x = key * 0x1E3779B97F4A7C15 in
  let x = (x lxor (x lsr 29)) * 0x3F58476D1CE4E5B9 in
  let x = (x lxor (x lsr 32)) * 0x14D049BB133111EB in
  (x lxor (x lsr 31)) land max_int mod below

let key s c b what = (((((s * 4) + c) * 4) + b) * 4) + what

(* Each state has two or three choices, each of one to three targets anywhere and, with a small weight, an end: one
   state of forty is one. *)
let random n =
  let choice s c =
    let branches = 1 + scrambled (key s c 0 0) 3 in
    let leak = (scrambled (key s c 3 1) (n / 40) * 40) + 39 in
    (leak, 1) :: List.init branches (fun b -> (scrambled (key s c b 1) n, 5 + scrambled (key s c b 2) 9))
  in
  {
    states = n;
    place = (fun s -> if s mod 80 = 79 then Goal else if s mod 80 = 39 then Other_end else Inside);
    choices = (fun s -> List.init (2 + scrambled (key s 3 3 3) 2) (choice s));
    timed = false;
  }

(* Rings of five states; each choice goes on in the ring or to some ring before, and the first two are the ends. *)
let rings n =
  let choice s c =
    let ring = s / 5 in
    let next = (ring * 5) + ((s + 1 + c) mod 5) and back = (ring * 5) + ((s + 4) mod 5) in
    let before b = ((ring - 1 - scrambled (key s c b 1) (Int.min ring 1_000)) * 5) + scrambled (key s c b 2) 5 in
    [ (next, 3 + scrambled (key s c 0 3) 4); (back, 2); (before 0, 2); (before 1, 1) ]
  in
  {
    states = n / 5 * 5;
    place = (fun s -> if s < 5 then Goal else if s < 10 then Other_end else Inside);
    choices = (fun s -> List.init (if s mod 2 = 0 then 2 else 1) (choice s));
    timed = false;
  }

let kinds = [ ("grid", grid); ("street", street); ("random", random); ("rings", rings) ]

let choices_of k s = match k.place s with Inside -> k.choices s | Goal | Other_end -> [ [ (s, 1) ] ]
let sum choice = List.fold_left (fun sum (_, w) -> sum + w) 0 choice

let build k =
  let b = Mdp.builder () in
  let shares = Hashtbl.create 1_000 in
  let share w sum =
    match Hashtbl.find_opt shares (w, sum) with
    | Some p -> p
    | None ->
      let p = rat w sum in
      Hashtbl.add shares (w, sum) p;
      p
  in
  for s = 0 to k.states - 1 do
    ignore (Mdp.add_state b);
    List.iter
      (fun choice ->
         let sum = sum choice in
         Mdp.add_choice b ~reward:Rat.one (List.map (fun (t, w) -> (t, share w sum)) choice))
      (choices_of k s)
  done;
  match Mdp.finish b with Ok m -> m | Error e -> failwith (Mdp.describe e)

(* In the format of Storm for explicit models, with the nearest float of each probability. *)
let write_drn k m file =
  let out = open_out file in
  Printf.fprintf out "@type: MDP\n@value_type: double\n@parameters\n\n@reward_models\ntime\n@nr_states\n%d\n"
    (Mdp.states m);
  Printf.fprintf out "@nr_choices\n%d\n@model\n" (Mdp.choices m);
  for s = 0 to Mdp.states m - 1 do
    let label = match k.place s with Goal -> " goal end" | Other_end -> " end" | Inside -> "" in
    Printf.fprintf out "state %d [0]%s%s\n" s (if s = 0 then " init" else "") label;
    for c = Mdp.first_choice m s to Mdp.first_choice m (s + 1) - 1 do
      Printf.fprintf out "\taction %d [1]\n" (c - Mdp.first_choice m s);
      for b = Mdp.first_branch m c to Mdp.first_branch m (c + 1) - 1 do
        Printf.fprintf out "\t\t%d : %.17g\n" (Mdp.target m b) (Rat.to_float (Mdp.probability m b))
      done
    done
  done;
  close_out out

(* {1 Questions} *)

let effort engine = { Effort.default with engine; relative = true }

let ask k m engine (name, direction, time) =
  Gc.compact ();
  let since = Sys.time () in
  let back = Backwards.make m in
  let is_goal s = match k.place s with Goal -> true | Other_end -> time | Inside -> false in
  let q = Qualitative.until back ~stay:(fun _ -> true) ~goal:is_goal in
  let solve = if time then Reward.solve else Reach.solve in
  let solution = solve q direction (effort engine) ~asked:All in
  let seconds = Sys.time () -. since in
  let sweeps = match Solution.found solution with In_intervals { sweeps; _ } -> sweeps | _ -> 0 in
  Printf.printf "question\t%s\t%.3f\t%d\n" name seconds sweeps;
  for i = 0 to 999 do
    let s = ((i * 7919) + (i * i)) * 131 mod k.states in
    let a = Solution.value solution s in
    let number = function Some x -> Printf.sprintf "%.17g" (Rat.to_float x) | None -> "inf" in
    Printf.printf "value\t%d\t%s\t%s\n" s (number (Answer.lower a)) (number (Answer.upper a))
  done;
  flush stdout

let () =
  let kind = ref "" and states = ref 1_000_000 and drn = ref "" and exact = ref false in
  Arg.parse
    [
      ("--states", Arg.Set_int states, "N  about so many (10^6)");
      ("--drn", Arg.Set_string drn, "FILE  writes the process as Storm reads it");
      ("--exact", Arg.Set exact, " in rationals");
    ]
    (fun s -> kind := s)
    ("decisions.exe [OPTIONS] " ^ String.concat "|" (List.map fst kinds));
  match List.assoc_opt !kind kinds with
  | None ->
    prerr_endline ("no such kind: " ^ !kind);
    exit 2
  | Some make ->
    let k = make !states in
    let m = build k in
    Printf.printf "process\t%d\t%d\t%d\n%!" (Mdp.states m) (Mdp.choices m) (Mdp.branches m);
    if !drn <> "" then write_drn k m !drn;
    List.iter
      (fun (name, direction, time) ->
         if k.timed || not time then
           ask k m (if !exact then Effort.Exactly else Effort.Nearly) (name, direction, time))
      [
        ({|Pmin=? [F "goal"]|}, Equations.Min, false);
        ({|Pmax=? [F "goal"]|}, Equations.Max, false);
        ({|R{"time"}min=? [F "end"]|}, Equations.Min, true);
        ({|R{"time"}max=? [F "end"]|}, Equations.Max, true);
      ]
