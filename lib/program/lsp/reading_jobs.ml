type running = { job : Job.t; since : float; of_text : Workspace.document }

type t = {
  session : Session.t;
  found : Workspace.document -> Analysis.t -> unit;
  say : string -> unit;
  due : (string, float) Hashtbl.t;  (* by address: when it is to be read *)
  running : (string, running) Hashtbl.t;
  took : (string, float) Hashtbl.t;
  files : (string, string list) Hashtbl.t;  (* that were read with a document *)
}

let create session ~found ~say =
  {
    session; found; say;
    due = Hashtbl.create 16;
    running = Hashtbl.create 16;
    took = Hashtbl.create 16;
    files = Hashtbl.create 16;
  }

let most_running = 2

(* Seconds. *)
let shortest = 0.05
let longest = 1.
let given_up = 60.
let jobs t = Hashtbl.fold (fun _ r found -> r.job :: found) t.running []

let stop t uri =
  match Hashtbl.find_opt t.running uri with
  | Some r ->
    Job.kill r.job;
    Hashtbl.remove t.running uri
  | None -> ()

let schedule t (d : Workspace.document) =
  stop t d.uri;
  Hashtbl.remove t.session.verdicts d.uri;
  let wait =
    match Hashtbl.find_opt t.took d.uri with
    | None -> 0.
    | Some took -> Float.max shortest (Float.min longest took)
  in
  Hashtbl.replace t.due d.uri (Unix.gettimeofday () +. wait)

let changed_file t path =
  let imports (d : Workspace.document) =
    match Hashtbl.find_opt t.files d.uri with Some files -> List.mem path files | None -> false
  in
  List.iter (schedule t) (List.filter imports (Workspace.all t.session.workspace))

let later t (d : Workspace.document) =
  schedule t d;
  Option.iter (changed_file t) d.path

let forget t (d : Workspace.document) =
  stop t d.uri;
  List.iter (fun table -> Hashtbl.remove table d.uri) [ t.due; t.took ];
  Hashtbl.remove t.files d.uri;
  Hashtbl.remove t.session.analyses d.uri;
  Hashtbl.remove t.session.verdicts d.uri;
  Option.iter (changed_file t) d.path

(* {1 Reading} *)

let ended t (d : Workspace.document) since result =
  Hashtbl.remove t.running d.uri;
  Hashtbl.replace t.took d.uri (Unix.gettimeofday () -. since);
  match (result : Analysis.t option) with
  | Some found ->
    Hashtbl.replace t.files d.uri found.files;
    Hashtbl.replace t.session.analyses d.uri (d.version, found);
    t.found d found
  | None ->
    let what = "came to an end, as when memory runs out" in
    t.say (Printf.sprintf "the process that read %s %s" (Uri.name d.uri) what)

let start t (d : Workspace.document) =
  Hashtbl.remove t.due d.uri;
  let since = Unix.gettimeofday () in
  let work _ = Analysis.of_document t.session.workspace d in
  match Job.start ~work ~progress:ignore ~ended:(ended t d since) with
  | Some job -> Hashtbl.replace t.running d.uri { job; since; of_text = d }
  | None -> Hashtbl.replace t.due d.uri (since +. longest)

let first_due t =
  let earlier uri (at : float) best = match best with Some (_, b) when b <= at -> best | _ -> Some (uri, at) in
  Hashtbl.fold earlier t.due None

let too_long t now =
  Hashtbl.fold (fun uri r found -> if now -. r.since > given_up then (uri, r) :: found else found) t.running []

let wait t =
  let now = Unix.gettimeofday () in
  let until_due =
    match first_due t with
    | Some (_, at) when Hashtbl.length t.running < most_running -> [ Float.max 0. (at -. now) ]
    | Some _ | None -> []
  in
  let until_late = Hashtbl.fold (fun _ r all -> Float.max 0.01 (r.since +. given_up -. now) :: all) t.running [] in
  match until_due @ until_late with [] -> -1. | first :: rest -> List.fold_left Float.min first rest

let rec go_on t =
  let now = Unix.gettimeofday () in
  List.iter
    (fun (uri, r) ->
       stop t uri;
       Hashtbl.replace t.took uri given_up;
       let name = Uri.name r.of_text.Workspace.uri in
       t.say (Printf.sprintf "reading %s takes more than a minute: it was given up" name))
    (too_long t now);
  match first_due t with
  | Some (uri, at) when at <= now && Hashtbl.length t.running < most_running ->
    (match Workspace.find t.session.workspace uri with
     | Some d -> start t d
     | None -> Hashtbl.remove t.due uri);
    go_on t
  | Some _ | None -> ()

let close t =
  Hashtbl.iter (fun _ r -> Job.kill r.job) t.running;
  Hashtbl.reset t.running;
  Hashtbl.reset t.due
