(* Markov chains of known values, solved by Scc_chance; test/bench/chance holds them against their bars.

     chances.exe KIND N

   KIND is one of those of [kinds], below. For each question a line is printed, of fields with tabs between them:
   its name, seconds of processor time from the finished chain on, how the value is known ("exact", or the width of
   its interval), and "right", "WRONG" or "unknown", as the closed form tells. *)

open Scc_exact
open Scc_chance

let rat n d = Rat.make (Z.of_int n) (Z.of_int d)

type question = { name : string; goal : int -> bool; time : bool; expected : Rat.t option }

(* Targets with weights of each state: one choice, which takes 1. *)
type chain = { states : int; choices : int -> (int * int) list list; start : int; questions : question list }

let ends name goal expected = { name; goal; time = false; expected }
let mean name goal expected = { name; goal; time = true; expected }

(* A fair walk on 0 .. n, absorbed at both ends, from a third of the way. *)
let walk n =
  let k = n / 3 in
  {
    states = n + 1;
    choices = (fun s -> [ (if s = 0 || s = n then [ (s, 1) ] else [ (s - 1, 1); (s + 1, 1) ]) ]);
    start = k;
    questions =
      [
        ends "P" (Int.equal n) (Some (rat k n));
        mean "E" (fun s -> s = 0 || s = n) (Some (Rat.of_int (k * (n - k))));
      ];
  }

(* The same with a choice: a step may be fair, or lead to the left more often. *)
let choosing n =
  let fair = walk n in
  let choices s =
    fair.choices s @ if s > 0 && s < n && s mod 3 = 0 then [ [ (s - 1, 2); (s + 1, 1) ] ] else []
  in
  { fair with choices; questions = [ List.hd fair.questions ] }

(* From 0 to one of two sides, and on a side to n places away, each reached from the one before by a fair coin, or
   back to 0. *)
let fall n =
  let power = Rat.make (Z.shift_left Z.one (n - 1)) Z.one in
  let last = (2 * n) + 1 in
  let choices s =
    [
      (if s = 0 then [ (1, 1); (n + 1, 1) ]
       else if s = n || s >= last - 1 then [ (s, 1) ]
       else [ (s + 1, 1); (0, 1) ]);
    ]
  in
  {
    states = last;
    choices;
    start = 0;
    questions =
      [
        ends "P" (Int.equal n) (Some Rat.half);
        mean "E" (fun s -> s = n || s = 2 * n) (Some (Rat.sub (Rat.mul (Rat.of_int 3) power) (Rat.of_int 2)));
      ];
  }

(* A fair walk on n by n places whose sides meet: to one of two places before the other one, and to either. *)
let torus n =
  let at x y = (((y + n) mod n) * n) + ((x + n) mod n) in
  let a = 0 and b = at (n / 3) (n / 4) in
  let choices s =
    let x = s mod n and y = s / n in
    [
      (if s = a || s = b then [ (s, 1) ]
       else [ (at (x + 1) y, 1); (at (x - 1) y, 1); (at x (y + 1), 1); (at x (y - 1), 1) ]);
    ]
  in
  {
    states = n * n;
    choices;
    start = at (n / 2) (n / 2);
    questions = [ ends "P" (Int.equal b) None; mean "E" (fun s -> s = a || s = b) None ];
  }

let scrambled key below =
  let x = key * 0x1E3779B97F4A7C15 in
  let x = (x lxor (x lsr 29)) * 0x3F58476D1CE4E5B9 in
  let x = (x lxor (x lsr 32)) * 0x14D049BB133111EB in
  (x lxor (x lsr 31)) land max_int mod below

(* Each state leads to three states anywhere; one in fifty is an end. *)
let anywhere n =
  let choices s =
    [ (if s mod 50 = 49 then [ (s, 1) ] else List.init 3 (fun b -> (scrambled ((s * 4) + b) n, b + 1))) ]
  in
  { states = n; choices; start = 0; questions = [ ends "P" (fun s -> s mod 100 = 49) None ] }

let kinds = [ ("walk", walk); ("choosing", choosing); ("fall", fall); ("torus", torus); ("anywhere", anywhere) ]

let build c =
  let b = Mdp.builder () in
  for s = 0 to c.states - 1 do
    ignore (Mdp.add_state b);
    List.iter
      (fun choice ->
         let sum = List.fold_left (fun sum (_, w) -> sum + w) 0 choice in
         Mdp.add_choice b ~reward:Rat.one (List.map (fun (t, w) -> (t, rat w sum)) choice))
      (c.choices s)
  done;
  match Mdp.finish b with Ok m -> m | Error e -> failwith (Mdp.describe e)

let width (a : Answer.t) =
  match (Answer.lower a, Answer.upper a) with
  | Some x, Some y -> Rat.to_float (Rat.sub y x)
  | _ -> infinity

let ask c m { name; goal; time; expected } =
  Gc.compact ();
  let since = Sys.time () in
  let q = Qualitative.until (Backwards.make m) ~stay:(fun _ -> true) ~goal in
  let solve = if time then Reward.solve else Reach.solve in
  let a = Solution.value (solve q Equations.Max Effort.default ~asked:(States [ c.start ])) c.start in
  let seconds = Sys.time () -. since in
  let known =
    match a with
    | Exact x -> Printf.sprintf "exact, %d bits" (Rat.bits x)
    | a -> Printf.sprintf "%.2g wide" (width a)
  in
  let judged =
    match expected with
    | None -> "unknown"
    | Some x -> if Answer.contains a x then "right" else "WRONG: " ^ Answer.to_string a
  in
  Printf.printf "%s\t%.3f\t%s\t%s\n%!" name seconds known judged

let () =
  match Array.to_list Sys.argv with
  | [ _; kind; n ] when List.mem_assoc kind kinds && Option.is_some (int_of_string_opt n) ->
    let c = (List.assoc kind kinds) (int_of_string n) in
    let m = build c in
    List.iter (ask c m) c.questions
  | _ ->
    prerr_endline ("chances.exe " ^ String.concat "|" (List.map fst kinds) ^ " N");
    exit 2
