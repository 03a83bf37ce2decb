open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

type owner = { name : string; shape : Shape.t; span : Span.t }

(* A definition on a structure. *)
type entry = {
  declared : Program.behaviour;
  first : owner;  (** whose need made it *)
  mutable body : Behaviour.t;  (** nil until it is elaborated *)
  mutable calls : int list;
  mutable private_to : string option;  (** the process whose name its features bear *)
}

type t = {
  c : Context.t;
  program : Program.t;
  index : (string * int, int) Hashtbl.t;
  mutable entries : entry list;  (** the last first *)
  mutable count : int;
  mutable sealed : int;  (** how many are part of the model *)
  pending : (int * entry) Queue.t;
  uses : (string * int, Span.t) Hashtbl.t;  (** a process and a definition that it may become *)
  channel_names : (string, unit) Hashtbl.t;
}

let ( let* ) = Option.bind

let behaviour_names program =
  Hashtbl.fold (fun name _ names -> name :: names) program.Program.behaviours [] |> List.sort String.compare

let find_template (c : Context.t) (name : Ast.name) =
  match Hashtbl.find_opt c.templates name.it with
  | Some t ->
    t.used <- true;
    t.shape
  | None -> None

let check_template (c : Context.t) (name : Ast.name) =
  if not (Hashtbl.mem c.templates name.it) then
    Report.error c.report Code.unknown_name name.at "unknown template `%s`" name.it
      ~near:(name.it, fun () -> Context.template_names c)

let create c (program : Program.t) =
  Hashtbl.iter (fun _ (b : Program.behaviour) -> Option.iter (check_template c) b.on) program.behaviours;
  {
    c;
    program;
    index = Hashtbl.create 16;
    entries = [];
    count = 0;
    sealed = 0;
    pending = Queue.create ();
    uses = Hashtbl.create 16;
    channel_names = Hashtbl.create 16;
  }

let use_channel t name = Hashtbl.replace t.channel_names name ()
let has_channel t name = Hashtbl.mem t.channel_names name
let channels t = Hashtbl.fold (fun name () all -> name :: all) t.channel_names [] |> List.sort String.compare

(* [on T]: the owner's shape has the structure of T, as an image of T by scaling has. *)
let fits t (declared : Program.behaviour) owner at =
  match declared.on with
  | None -> true
  | Some template -> (
      match find_template t.c template with
      | None -> true
      | Some shape when Int.equal (Shape.structure shape) (Shape.structure owner.shape) -> true
      | Some _ ->
        Report.error t.c.report Code.wrong_template at "`%s` is a behaviour on `%s`, and `%s` is a `%s`"
          declared.name.it template.it owner.name (Shape.label owner.shape)
          ~notes:[ (template.at, "it says so here") ];
        false)

let enter t declared owner key =
  let entry = { declared; first = owner; body = Behaviour.nil; calls = []; private_to = None } in
  let i = t.count in
  declared.Program.used <- true;
  Hashtbl.add t.index key i;
  t.entries <- entry :: t.entries;
  t.count <- i + 1;
  Queue.add (i, entry) t.pending;
  i

let unknown t (name : Ast.name) =
  Report.error t.c.report Code.unknown_name name.at "unknown behaviour `%s`" name.it
    ~near:(name.it, fun () -> behaviour_names t.program)

let request t owner (name : Ast.name) =
  match Hashtbl.find_opt t.program.behaviours name.it with
  | None ->
    unknown t name;
    None
  | Some declared ->
    if not (fits t declared owner name.at) then None
    else
      let key = (name.it, Shape.structure owner.shape) in
      Some
        (match Hashtbl.find_opt t.index key with
         | Some i -> i
         | None -> enter t declared owner key)

let definition t owner name =
  let* i = request t owner name in
  Hashtbl.replace t.uses (owner.name, i) name.at;
  Some i

(* What the elaboration of one term needs to know and to tell. *)
type scope = {
  env : Env.t;
  owner : owner;
  call : Ast.name -> int option;
  own_name : unit -> unit;  (** a feature bears the owner's name *)
}

let site t scope (f : Ast.feature) =
  let* read = Feature_name.read t.c.report scope.env f in
  let* site = Feature_name.on_shape t.c.report ~own:(Some scope.owner.name) scope.owner.shape read in
  (match read.prefix with
   | (first, _) :: _ when String.equal first scope.owner.name -> scope.own_name ()
   | _ -> ());
  Some site

(* Without its edges and corners a face is open: there is no first instant at which two such faces meet that slide
   into each other (reading I-33). *)
let check_only t (m : Ast.member) =
  match Settings.binding t.program.settings with
  | On_collision -> ()
  | On_contact ->
    Report.error t.c.report Code.not_yet m.feature.at
      "`only` cannot be had with `binding contact`: there may be no first instant at which two features without \
       their closures touch"
      ~hint:"leave out `only`, or bind on collision"

let channel t scope (ch : Ast.channel) =
  use_channel t ch.channel.it;
  let read (m : Ast.member) =
    if m.only then check_only t m;
    Option.map (fun site -> (m.only, site)) (site t scope m.feature)
  in
  let members = Long_list.map read ch.features in
  if List.length ch.features = 0 then begin
    Report.error t.c.report Code.empty_channel ch.span "the channel `%s` has no features" ch.channel.it;
    None
  end
  else if List.for_all Option.is_some members then
    let only, sites = List.partition fst (List.filter_map Fun.id members) in
    let only = Long_list.map snd only and sites = Long_list.map snd sites in
    let closure = Feature_name.closure scope.owner.shape sites in
    Some (Behaviour.channel ~only ~name:ch.channel.it ~sites ~closure ())
  else None

let channels_of t scope at list =
  let read = Long_list.map (channel t scope) list in
  match read with
  | [] ->
    Report.error t.c.report Code.empty_channel at "a strong split needs at least one channel";
    None
  | _ :: _ -> if List.for_all Option.is_some read then Some (List.filter_map Fun.id read) else None

let delay t env (e : Ast.expr) =
  match Constant.number t.c.report env e with
  | Some q when Rat.sign q >= 0 -> Some q
  | Some q ->
    Report.error t.c.report Code.negative_delay e.at "a delay is not negative, and this is %s"
      (Rat.to_string q);
    None
  | None -> None

let polarity (ch : Ast.channel) = if ch.co then Behaviour.Co_name else Behaviour.Name

(* Both parts are read before either is looked at, so that the faults of both are found. *)
let rec elaborate t scope (b : Ast.behaviour) =
  match b.it with
  | Nil -> Some Behaviour.nil
  | Name name -> Option.map Behaviour.call (scope.call name)
  | Open (ch, rest) ->
    let* c, b = Typed.both (channel t scope ch) (elaborate t scope rest) in
    Some (Behaviour.open_ (polarity ch) c b)
  | Weak (ch, rest) ->
    let* c, b = Typed.both (channel t scope ch) (elaborate t scope rest) in
    Some (Behaviour.weak c b)
  | Strong (list, rest) ->
    let* cs, b = Typed.both (channels_of t scope b.at list) (elaborate t scope rest) in
    Some (Behaviour.strong cs b)
  | Delay (e, rest) ->
    let* d, b = Typed.both (delay t scope.env e) (elaborate t scope rest) in
    Some (Behaviour.delay d b)
  | Sum (first, second) ->
    let* a, b = Typed.both (elaborate t scope first) (elaborate t scope second) in
    Some (Behaviour.sum a b)

let term t env owner b = elaborate t { env; owner; call = definition t owner; own_name = ignore } b

let complete t (_, entry) =
  let call name =
    let i = request t entry.first name in
    Option.iter (fun i -> entry.calls <- i :: entry.calls) i;
    i
  in
  let own_name () = entry.private_to <- Some entry.first.name in
  let scope = { env = entry.declared.env; owner = entry.first; call; own_name } in
  Option.iter (fun b -> entry.body <- b) (elaborate t scope entry.declared.body)

let rec settle t =
  match Queue.take_opt t.pending with
  | None -> ()
  | Some next ->
    complete t next;
    settle t

let all t = Array.of_list (List.rev t.entries)

(* The definitions that a definition may become. *)
let reachable entries start =
  let seen = Hashtbl.create 8 in
  let rec visit = function
    | [] -> ()
    | i :: rest when Hashtbl.mem seen i -> visit rest
    | i :: rest ->
      Hashtbl.add seen i ();
      visit (List.rev_append entries.(i).calls rest)
  in
  visit [ start ];
  Hashtbl.fold (fun i () list -> i :: list) seen [] |> List.sort Int.compare

let by_name_and_index ((name, i), _) ((name', i'), _) =
  let c = String.compare name name' in
  if c <> 0 then c else Int.compare i i'

let check_private t entries =
  let check ((name, start), at) =
    let stray i =
      match entries.(i).private_to with
      | Some p when not (String.equal p name) -> Some (entries.(i), p)
      | Some _ | None -> None
    in
    match List.find_map stray (reachable entries start) with
    | None -> ()
    | Some (entry, p) ->
      Report.error t.c.report Code.unknown_feature at
        "`%s` names features of `%s`, and cannot be the behaviour of `%s`" entry.declared.name.it p name
        ~hint:"name the features alone, without the process"
  in
  if Array.exists (fun e -> Option.is_some e.private_to) entries then
    Hashtbl.fold (fun use at list -> (use, at) :: list) t.uses []
    |> List.sort by_name_and_index |> List.iter check

let in_order (a : Program.behaviour) (b : Program.behaviour) = Int.compare a.name.at.start b.name.at.start

let unguarded_at t (name : Ast.name) =
  Report.error t.c.report Code.unguarded name.at "the recursion of `%s` is not guarded" name.it
    ~hint:"between a name and its recurrence there must be a channel, a split or a positive delay"

(* {2 What nothing uses}

   It is read as well, on the template that it names. Without a template there are no features to look up,
   but the names of behaviours, the delays and the guards can be checked as they stand. *)

let rec check_names t env (b : Ast.behaviour) =
  match b.it with
  | Nil -> ()
  | Open (_, rest) | Weak (_, rest) | Strong (_, rest) -> check_names t env rest
  | Delay (e, rest) ->
    ignore (delay t env e);
    check_names t env rest
  | Sum (first, second) ->
    check_names t env first;
    check_names t env second
  | Name name ->
    if not (Hashtbl.mem t.program.behaviours name.it) then unknown t name

(* The names that may be unfolded without anything happening; a delay that is no literal zero guards. *)
let rec exposed found (b : Ast.behaviour) =
  match b.it with
  | Nil | Open _ | Weak _ | Strong _ -> found
  | Delay ({ it = Number q; _ }, rest) when Rat.sign q = 0 -> exposed found rest
  | Delay _ -> found
  | Sum (first, second) -> exposed (exposed found first) second
  | Name name -> name.it :: found

let reaches_itself t (b : Program.behaviour) =
  let seen = Hashtbl.create 8 in
  let rec visit = function
    | [] -> false
    | name :: _ when String.equal name b.name.it -> true
    | name :: rest when Hashtbl.mem seen name -> visit rest
    | name :: rest -> (
        Hashtbl.add seen name ();
        match Hashtbl.find_opt t.program.behaviours name with
        | None -> visit rest
        | Some (next : Program.behaviour) -> visit (exposed rest next.body))
  in
  visit (exposed [] b.body)

let read_unused t =
  let unused _ (b : Program.behaviour) list = if b.used then list else b :: list in
  let read (b : Program.behaviour) =
    match (b.on, Option.bind b.on (find_template t.c)) with
    | None, _ ->
      check_names t b.env b.body;
      if reaches_itself t b then unguarded_at t b.name
    | Some _, None -> ()
    | Some _, Some shape ->
      ignore (request t { name = ""; shape; span = b.name.at } b.name);
      b.used <- false
  in
  List.iter read (List.sort in_order (Hashtbl.fold unused t.program.behaviours []))

let check_guarded t entries definitions =
  List.iter (fun i -> unguarded_at t entries.(i).declared.name) (Behaviour.unguarded definitions)

let seal t =
  settle t;
  t.sealed <- t.count

let finish t =
  settle t;
  read_unused t;
  settle t;
  let entries = all t in
  let definitions =
    Array.map (fun e -> { Behaviour.name = e.declared.name.it; body = e.body }) entries
  in
  check_private t entries;
  check_guarded t entries definitions;
  Array.sub definitions 0 t.sealed
