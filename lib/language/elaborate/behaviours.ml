open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

type owner = { name : string; shape : Shape.t }

(* A definition on a structure. *)
type entry = {
  declared : Program.behaviour;
  label : string;  (** of the instance *)
  env : Env.t;
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
  mutable overflow : bool;  (** more are needed than there may be, which is reported *)
  mutable sealed : int;  (** how many are part of the model *)
  pending : (int * entry) Queue.t;
  uses : (string * int, Span.t) Hashtbl.t;  (** a process and a definition that it may become *)
  channel_names : (string, unit) Hashtbl.t;
}

(* Instances of all behaviours on all structures. *)
let max_definitions = 10_000

let check_template (c : Context.t) (b : Program.behaviour) =
  match (b.on, b.formals) with
  | Some on, [] -> ignore (Templates.find c b.env on)
  | Some _, _ :: _ | None, _ -> ()

let create c (program : Program.t) =
  Hashtbl.iter (fun _ b -> check_template c b) program.behaviours;
  {
    c;
    program;
    index = Hashtbl.create 16;
    entries = [];
    count = 0;
    overflow = false;
    sealed = 0;
    pending = Queue.create ();
    uses = Hashtbl.create 16;
    channel_names = Hashtbl.create 16;
  }

let copy t c =
  let index = Hashtbl.copy t.index and uses = Hashtbl.copy t.uses and names = Hashtbl.copy t.channel_names in
  { t with c; index; uses; channel_names = names; pending = Queue.copy t.pending }

let count t = t.count
let use_channel t name = Hashtbl.replace t.channel_names name ()
let has_channel t name = Hashtbl.mem t.channel_names name
let channels t = Hashtbl.fold (fun name () all -> name :: all) t.channel_names [] |> List.sort String.compare

(* [on T]: the owner's shape has the structure of T, as an image of T by scaling has. *)
let fits t (declared : Program.behaviour) label env owner at =
  match declared.on with
  | None -> true
  | Some template -> (
      match Templates.find t.c env template with
      | None -> true
      | Some shape when Int.equal (Shape.structure shape) (Shape.structure owner.shape) -> true
      | Some shape ->
        Report.error t.c.report Code.wrong_template at "`%s` is a behaviour on `%s`, and `%s` is a `%s`"
          (Env.said t.c.root label) (Env.said t.c.root (Shape.label shape)) owner.name
          (Env.said t.c.root (Shape.label owner.shape))
          ~notes:[ (template.target.at, "it says so here") ];
        false)

let enter t declared label env owner key =
  let entry = { declared; label; env; first = owner; body = Behaviour.nil; calls = []; private_to = None } in
  let i = t.count in
  declared.Program.used <- true;
  Hashtbl.add t.index key i;
  t.entries <- entry :: t.entries;
  t.count <- i + 1;
  Queue.add (i, entry) t.pending;
  i

let unknown t env r reference =
  Family.report_unknown t.c.report env "behaviour" (Family.keys t.program.behaviours) r reference

(* The instance [label] on the owner's shape. *)
let request_instance t owner at (declared : Program.behaviour) label env =
  if not (fits t declared label env owner at) then None
  else
    let key = (label, Shape.structure owner.shape) in
    match Hashtbl.find_opt t.index key with
    | Some i -> Some i
    | None when t.count >= max_definitions ->
      let hint =
        match declared.formals with
        | [] -> None
        | _ :: _ -> Some "a family that asks for an instance of its own with ever other arguments has no end"
      in
      if not t.overflow then
        Report.error t.c.report Code.too_deep at "the model has more than %d %s: `%s`" max_definitions
          (if Option.is_none hint then "behaviours" else "instances of behaviours")
          (Env.said t.c.root label) ?hint;
      t.overflow <- true;
      None
    | None -> Some (enter t declared label env owner key)

let request t env owner (r : Ast.reference) =
  let*? reference = Family.reference t.c.report env r in
  match Family.find t.program.behaviours reference with
  | _ when Family.is_open reference ->
    if not (Family.has t.program.behaviours reference) then unknown t env r reference;
    None
  | None ->
    unknown t env r reference;
    None
  | Some declared ->
    let env = Family.bind declared.env declared.formals reference.arguments in
    let env = Family.define t.c.report env declared.definitions in
    request_instance t owner r.target.at declared reference.label env

let definition t env owner (r : Ast.reference) =
  let*? i = request t env owner r in
  Hashtbl.replace t.uses (owner.name, i) r.target.at;
  Some i

(* What the elaboration of one term needs to know and to tell. *)
type scope = {
  env : Env.t;
  owner : owner;
  call : Ast.reference -> int option;
  own_name : unit -> unit;  (** a feature bears the owner's name *)
}

let site t scope (f : Ast.feature) =
  let*? read = Feature_name.read t.c.report scope.env f in
  let*? meaning = Feature_name.on_shape t.c.report ~own:(Some scope.owner.name) scope.owner.shape read in
  (match read.prefix with
   | (first, _) :: _ when String.equal first scope.owner.name -> scope.own_name ()
   | _ -> ());
  Some meaning

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

(* When features meet is asked of whole faces of parts (rule Collision with [binding contact]). *)
let check_pieces t scope (m : Ast.member) meaning =
  match Settings.binding t.program.settings with
  | On_contact when not (Feature_name.closed_by_parts scope.owner.shape meaning) ->
    Report.error t.c.report Code.not_yet m.feature.at
      "this face cannot be had with `binding contact`: it is in pieces whose edges belong to other faces as well"
      ~hint:"name pieces of it by their parts, as in `p1.top`, or bind on collision"
  | On_contact | On_collision -> ()

let channel t scope (ch : Ast.channel) =
  let name = Family.word scope.env ch.channel.it in
  use_channel t name;
  let read (m : Ast.member) =
    if m.only then check_only t m;
    let*? meaning = site t scope m.feature in
    check_pieces t scope m meaning;
    Some (m.only, meaning)
  in
  let members = List.map read ch.features in
  if List.length ch.features = 0 then begin
    Report.error t.c.report Code.empty_channel ch.span "the channel `%s` has no features" ch.channel.it;
    None
  end
  else if List.for_all Option.is_some members then
    let only, sites = List.partition fst (List.filter_map Fun.id members) in
    let all list of_meaning = List.concat_map (fun (_, m) -> of_meaning m) list in
    let only = all only (fun (m : Feature_name.meaning) -> m.inside) in
    let listed = all sites (fun m -> m.listed) and closure = all sites (fun m -> m.closed) in
    Some (Behaviour.channel ~only ~name ~sites:listed ~closure ())
  else None

let channels_of t scope at list =
  let read = List.map (channel t scope) list in
  match read with
  | [] ->
    Report.error t.c.report Code.empty_channel at "a strong split needs at least one channel";
    None
  | _ :: _ -> if List.for_all Option.is_some read then Some (List.filter_map Fun.id read) else None

let linear t form = Form.linear (Array.length t.program.ranges) form

let check_delay t (e : Ast.expr) form =
  match Form.constant form with
  | Some q when Rat.sign q < 0 ->
    Report.error t.c.report Code.negative_delay e.at "a delay is not negative, and this is %s" (Rat.to_string q);
    false
  | Some _ -> true
  | None -> (
      match Ranges.negative t.program.ranges (linear t form) with
      | None -> true
      | Some values ->
        let value (name, q) = Printf.sprintf "%s = %s" name (Rat.to_string q) in
        Report.error t.c.report Code.negative_delay e.at "a delay is not negative, and this is for %s"
          (String.concat ", " (List.map value values));
        false)

let delay t env (e : Ast.expr) =
  Option.bind (Constant.form t.c.report env e) (fun form ->
      if check_delay t e form then Some (linear t form) else None)

let push t env j = Release.push t.c.report env j

let loosening t env ({ push = j; odds } : Ast.loosening) =
  Typed.both (push t env j) (Release.odds t.c.report ~splits:t.program.splits env odds)

let polarity (ch : Ast.channel) = if ch.co then Behaviour.Co_name else Behaviour.Name

(* Both parts are read before either is looked at, so that the faults of both are found. *)
let rec elaborate t scope (b : Ast.behaviour) =
  match b.it with
  | Nil -> Some Behaviour.nil
  | Name r -> Option.map Behaviour.call (scope.call r)
  | Open (ch, rest) ->
    let*? c, b = Typed.both (channel t scope ch) (elaborate t scope rest) in
    Some (Behaviour.open_ (polarity ch) c b)
  | Weak (ch, j, rest) ->
    let*? (c, b), (push, odds) =
      Typed.both (Typed.both (channel t scope ch) (elaborate t scope rest)) (loosening t scope.env j)
    in
    Some (Behaviour.weak ~push ?odds c b)
  | Strong (list, j, rest) ->
    let*? (cs, b), push =
      Typed.both (Typed.both (channels_of t scope b.at list) (elaborate t scope rest)) (push t scope.env j)
    in
    Some (Behaviour.strong ~push cs b)
  | Delay (e, rest) ->
    let*? d, b = Typed.both (delay t scope.env e) (elaborate t scope rest) in
    Some (Behaviour.written d b)
  | Sum (first, second) ->
    let*? a, b = Typed.both (elaborate t scope first) (elaborate t scope second) in
    Some (Behaviour.sum a b)

let term t env owner b = elaborate t { env; owner; call = definition t env owner; own_name = ignore } b

let complete t (_, (entry : entry)) =
  let call r =
    let i = request t entry.env entry.first r in
    Option.iter (fun i -> entry.calls <- i :: entry.calls) i;
    i
  in
  let own_name () = entry.private_to <- Some entry.first.name in
  let scope = { env = entry.env; owner = entry.first; call; own_name } in
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
  String.compare name name' <?> fun () -> Int.compare i i'

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
        "`%s` names features of `%s`, and cannot be the behaviour of `%s`"
        (Env.said t.c.root entry.label) p name
        ~hint:"name the features alone, without the process"
  in
  if Array.exists (fun e -> Option.is_some e.private_to) entries then
    Hashtbl.fold (fun use at list -> (use, at) :: list) t.uses []
    |> List.sort by_name_and_index |> List.iter check

let in_order (a : Program.behaviour) (b : Program.behaviour) = Int.compare a.name.at.start b.name.at.start

let unguarded_at t (b : Program.behaviour) label =
  Report.error t.c.report Code.unguarded b.name.at "the recursion of `%s` is not guarded" (Env.said b.env label)
    ~hint:"between a name and its recurrence there must be a channel, a split or a positive delay"

(* {2 What nothing uses}

   It is read as well, on the template that it names, and a family without arguments. Without a template there are
   no features to look up, but the names of behaviours, the delays and the guards can be checked as they stand. *)

let rec check_names t env (b : Ast.behaviour) =
  match b.it with
  | Nil -> ()
  | Open (_, rest) -> check_names t env rest
  | Weak (_, j, rest) ->
    ignore (loosening t env j);
    check_names t env rest
  | Strong (_, j, rest) ->
    ignore (push t env j);
    check_names t env rest
  | Delay (e, rest) ->
    ignore (delay t env e);
    check_names t env rest
  | Sum (first, second) ->
    check_names t env first;
    check_names t env second
  | Name r ->
    Option.iter
      (fun reference ->
         if not (Family.has t.program.behaviours reference) then unknown t env r reference)
      (Family.reference t.c.report env r)

(* The names that may be unfolded without anything happening; a delay that is no literal zero guards. *)
let rec exposed found (b : Ast.behaviour) =
  match b.it with
  | Nil | Open _ | Weak _ | Strong _ -> found
  | Delay ({ it = Number q; _ }, rest) when Rat.sign q = 0 -> exposed found rest
  | Delay _ -> found
  | Sum (first, second) -> exposed (exposed found first) second
  | Name { qualifier = None; target; indices = []; arguments = [] } -> target.it :: found
  | Name _ -> found

(* Of those without indices and parameters. *)
let reaches_itself t (b : Program.behaviour) =
  let seen = Hashtbl.create 8 in
  let rec visit = function
    | [] -> false
    | name :: _ when String.equal name b.label -> true
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
    let env = Family.bind b.env b.formals (Family.unknown b.formals) in
    let env = Family.define t.c.report env b.definitions in
    match (b.on, Option.bind b.on (Templates.find t.c env)) with
    | None, _ ->
      check_names t env b.body;
      if reaches_itself t b then unguarded_at t b b.label
    | Some _, None -> check_names t env b.body
    | Some _, Some shape ->
      ignore (request_instance t { name = ""; shape } b.name.at b b.label env);
      b.used <- false
  in
  List.iter read (List.sort in_order (Hashtbl.fold unused t.program.behaviours []))

let check_guarded t entries definitions =
  List.iter
    (fun i -> unguarded_at t entries.(i).declared entries.(i).label)
    (Behaviour.unguarded ~may_be_zero:(Ranges.may_be_zero t.program.ranges) definitions)

let seal t =
  settle t;
  t.sealed <- t.count

let finish t =
  settle t;
  read_unused t;
  settle t;
  let entries = all t in
  let definitions =
    Array.map (fun e -> { Behaviour.name = e.label; body = e.body }) entries
  in
  check_private t entries;
  check_guarded t entries definitions;
  Array.sub definitions 0 t.sealed
