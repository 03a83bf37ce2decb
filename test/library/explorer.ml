(* A program that uses scc as a library: it explores the states of a model by itself, breadth first, checks the
   model, and writes a page and a picture to look at.

   explorer MODEL... *)

module States = Hashtbl.Make (struct
    type t = Scc_library.state

    let equal = Scc_library.equal
    let hash = Scc_library.hash
  end)

exception Refused of Scc_library.problem list

let good = function Ok x -> x | Error problems -> raise (Refused problems)

(* The states that can be reached, with the number of transitions and the time to each. *)
let explore model =
  let known = States.create 100 and queue = Queue.create () and transitions = ref 0 in
  let reach state time =
    if not (States.mem known state) then begin
      States.add known state ();
      Queue.push (state, time) queue
    end
  in
  reach (good (Scc_library.initial model)) Q.zero;
  let latest = ref Q.zero in
  while not (Queue.is_empty queue) do
    let state, time = Queue.pop queue in
    latest := Q.max !latest time;
    let follow (t : Scc_library.transition) =
      incr transitions;
      reach t.target (Q.add time t.duration)
    in
    List.iter follow (good (Scc_library.successors model state))
  done;
  (States.length known, !transitions, !latest)

(* One run, by the first transition of each state. *)
let walk model =
  let rec from state n =
    let show (b : Scc_library.body) =
      let x, y, z = b.position in
      let place = String.concat ", " (List.map Q.to_string [ x; y; z ]) in
      Printf.printf "    %s at (%s): %s\n" b.body place b.behaviour
    in
    match good (Scc_library.successors model state) with
    | first :: _ when n > 0 ->
      Printf.printf "  %s: %s\n" first.kind first.label;
      from first.target (n - 1)
    | _ :: _ | [] ->
      List.iter show (Scc_library.bodies model state);
      if Scc_library.quiescent model state then print_endline "  nothing happens any more"
  in
  from (good (Scc_library.initial model)) 4

let measure write =
  let size = ref 0 in
  write (fun piece -> size := !size + String.length piece);
  !size

let describe path =
  Printf.printf "== %s\n" (Filename.basename path);
  let model = good (Scc_library.load_file path) in
  let report = good (Scc_library.check model) in
  List.iter (fun (v : Scc_library.verdict) -> Printf.printf "%s: %s (%s)\n" v.name v.kind v.text) report.verdicts;
  Printf.printf "checked: %d states, %d transitions, %s\n" report.states report.transitions
    (if report.complete then "complete" else "not complete");
  Printf.printf "a report: %b\n" (measure report.json > 1000);
  let page = measure (fun write -> good (Scc_library.page ~title:"a page" model write)) in
  Printf.printf "a page: %b\n" (page > 100_000);
  let states, transitions, time = explore model in
  Printf.printf "explored: %d states, %d transitions, until %s\n" states transitions (Q.to_string time);
  walk model;
  let picture = Scc_library.picture model (good (Scc_library.initial model)) in
  Printf.printf "a picture: %b\n" (String.length picture > 1000)

(* A text that is no file. It imports one, which this program has in memory. *)
let of_text () =
  print_endline "== a text";
  let read = function
    | "cubes.sc" -> Ok "import <solids>\nbehaviour Idle on solids.Cube(2) = nil\n"
    | other -> Error (other ^ " is not here")
  in
  let text =
    "import \"cubes.sc\"\nimport <solids>\nparam far = 3\n\
     process cube = solids.Cube(2) mass 1 [cubes.Idle]\ncheck near : always x(cube) < far\n"
  in
  let model = good (Scc_library.load ~read ~set:[ ("far", Q.of_int 7) ] text) in
  List.iter (fun (p : Scc_library.problem) -> print_endline p.text) (Scc_library.warnings model);
  let report = good (Scc_library.check model) in
  let show (v : Scc_library.verdict) = Printf.printf "%s: %s: %s\n" v.name v.formula v.text in
  List.iter show report.verdicts;
  walk model;
  match Scc_library.load "import \"cubes.sc\"\n" with
  | Ok _ -> print_endline "that file cannot be there"
  | Error problems -> List.iter (fun (p : Scc_library.problem) -> print_string p.text) problems

let show_problems = function
  | Ok _ -> print_endline "accepted"
  | Error problems ->
    List.iter (fun (p : Scc_library.problem) -> Printf.printf "%s: %s\n" p.code p.message) problems

(* What is no value, no bound and no file is refused in words. *)
let refused () =
  print_endline "== refused";
  let text =
    "import <solids>\nparam far = 3\nprocess cube = solids.Cube(far) mass 1 [nil]\n\
     check c : always x(cube) < far\n"
  in
  List.iter
    (fun value -> show_problems (Scc_library.load ~set:[ ("far", value) ] text))
    [ Q.inf; Q.minus_inf; Q.undef; { Q.num = Z.zero; den = Z.zero } ];
  let start value = good (Scc_library.initial (good (Scc_library.load ~set:[ ("far", value) ] text))) in
  let three = Z.of_int (-3) in
  let same = Scc_library.equal (start Q.one) (start { Q.num = three; den = three }) in
  Printf.printf "in its lowest terms: %b\n" same;
  let model = good (Scc_library.load text) in
  show_problems (Scc_library.check ~states:(-1) model);
  show_problems (Scc_library.check ~depth:(-1) model);
  show_problems (Scc_library.check ~states:0 ~depth:0 model);
  show_problems (Scc_library.page ~states:(-1) ~title:"a page" model ignore);
  List.iter (fun path -> show_problems (Scc_library.load_file path)) [ "."; "/"; "explorer.ml/x"; "" ]

let () =
  let attempt f =
    try f () with
    | Refused problems ->
      List.iter (fun (p : Scc_library.problem) -> Printf.printf "%s: %s\n" p.code p.message) problems
  in
  attempt of_text;
  attempt refused;
  List.iter (fun path -> attempt (fun () -> describe path)) (List.tl (Array.to_list Sys.argv))
