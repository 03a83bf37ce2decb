(* Who is heard at present: sockets with their greetings. *)
type state = {
  self : Greeting.self;
  links : Link.t option array;
  mutable talks : (Unix.file_descr * Greeting.talk * bool) list;  (** true for those that were called *)
  mutable turned_away : (int * string) option;  (** how many callers, and why the last *)
}

let close fd = match Unix.close fd with () | (exception Unix.Unix_error _) -> ()

(* The one that calls has the greater number. *)
let missing s =
  List.filter (fun k -> k <> s.self.number && Option.is_none s.links.(k)) (List.init s.self.count Fun.id)

let why (f : Failure.t) = match f with Refused d -> d.message | Lost text -> text

(* Whom this owner has called is the right one, or there is none. Anybody may call it. *)
let turn_away s fd ~called f =
  if called then raise (Failure.Failed f);
  close fd;
  s.turned_away <- Some (1 + Option.fold ~none:0 ~some:fst s.turned_away, why f)

let drop s fd = s.talks <- List.filter (fun (other, _, _) -> not (other == fd)) s.talks

let hear s (fd, talk, called) =
  let wanted k =
    k < s.self.count && Option.is_none s.links.(k) && if called then k < s.self.number else k > s.self.number
  in
  match Greeting.hear s.self talk ~wanted with
  | false -> ()
  | true ->
    let peer = Greeting.peer talk in
    drop s fd;
    if wanted peer then s.links.(peer) <- Some (Link.make ~peer fd) else close fd
  | exception Failure.Failed f ->
    drop s fd;
    turn_away s fd ~called f

let called_by s listener =
  match Unix.accept ~cloexec:true listener with
  | fd, _ -> (
      match Greeting.talk s.self fd with
      | talk -> s.talks <- (fd, talk, false) :: s.talks
      | exception Failure.Failed f -> turn_away s fd ~called:false f)
  | exception Unix.Unix_error ((EAGAIN | EWOULDBLOCK | EINTR | ECONNABORTED), _, _) -> ()

let call s (host, port) k ~seconds =
  let failed what = Failure.lost "owner %d at %s:%d cannot be reached: %s" (k + 1) host port what in
  let address =
    match Unix.getaddrinfo host (string_of_int port) [ AI_SOCKTYPE SOCK_STREAM ] with
    | { ai_addr; _ } :: _ -> ai_addr
    | [] -> failed "nobody knows this name"
  in
  let fd = Unix.socket ~cloexec:true (Unix.domain_of_sockaddr address) SOCK_STREAM 0 in
  Unix.set_nonblock fd;
  let checked () = match Unix.getsockopt_error fd with Some e -> failed (Unix.error_message e) | None -> () in
  (match Unix.connect fd address with
   | () -> ()
   | exception Unix.Unix_error ((EINPROGRESS | EINTR | EAGAIN), _, _) -> (
       match Unix.select [] [ fd ] [] seconds with
       | _, [], _ -> failed "it does not answer in time"
       | _ -> checked ())
   | exception Unix.Unix_error (e, _, _) -> failed (Unix.error_message e));
  s.talks <- (fd, Greeting.talk s.self ~expected:k fd, true) :: s.talks

let gave_up s seconds =
  let who = String.concat ", " (List.map (fun k -> string_of_int (k + 1)) (missing s)) in
  let callers =
    match s.turned_away with
    | None -> ""
    | Some (n, why) -> Printf.sprintf "; %d that called were turned away, the last since %s" n why
  in
  Failure.lost "not all owners have come within %g seconds: owner %s is missing%s" seconds who callers

let meet self ~listener ~peers ~seconds =
  let s = { self; links = Array.make self.Greeting.count None; talks = []; turned_away = None } in
  let stop = Unix.gettimeofday () +. seconds in
  let left () = stop -. Unix.gettimeofday () in
  Unix.set_nonblock listener;
  List.iteri (fun k peer -> if k < self.number then call s peer k ~seconds:(Float.max 0. (left ()))) peers;
  while missing s <> [] do
    if left () <= 0. then gave_up s seconds;
    let fds = listener :: List.map (fun (fd, _, _) -> fd) s.talks in
    match Unix.select fds [] [] (Float.max 0. (left ())) with
    | ready, _, _ ->
      if List.memq listener ready then called_by s listener;
      List.iter (fun ((fd, _, _) as talk) -> if List.memq fd ready then hear s talk) s.talks
    | exception Unix.Unix_error (EINTR, _, _) -> ()
  done;
  List.iter (fun (fd, _, _) -> close fd) s.talks;
  close listener;
  s.links
