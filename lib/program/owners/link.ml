type t = {
  fd : Unix.file_descr;
  peer : int;
  out : string Queue.t;
  mutable sent : int;  (** bytes of the first of [out] that have been written *)
  mutable waiting : int;  (** bytes of [out] that have not *)
  mutable input : Bytes.t;
  mutable have : int;  (** bytes of [input] that have been read *)
}

let most = 1 lsl 20
let head = 5

let make ~peer fd =
  Unix.set_nonblock fd;
  { fd; peer; out = Queue.create (); sent = 0; waiting = 0; input = Bytes.create 65536; have = 0 }

let peer l = l.peer
let descriptor l = l.fd
let waiting l = l.waiting
let gone l = Failure.lost "owner %d is lost: its connection has ended" (l.peer + 1)

(* {1 Writing} *)

let rec flush l =
  match Queue.peek_opt l.out with
  | None -> ()
  | Some text -> (
      match Unix.write_substring l.fd text l.sent (String.length text - l.sent) with
      | n ->
        l.waiting <- l.waiting - n;
        l.sent <- l.sent + n;
        if l.sent = String.length text then begin
          ignore (Queue.pop l.out);
          l.sent <- 0;
          flush l
        end
      | exception Unix.Unix_error (EINTR, _, _) -> flush l
      | exception Unix.Unix_error ((EAGAIN | EWOULDBLOCK), _, _) -> ()
      | exception Unix.Unix_error _ -> gone l)

let post l kind text =
  let n = String.length text in
  if n > most then Scc_base.Bug.fail __POS__ "a message that is too long";
  let message = Bytes.create (head + n) in
  Bytes.set_int32_le message 0 (Int32.of_int n);
  Bytes.set message 4 kind;
  Bytes.blit_string text 0 message head n;
  Queue.push (Bytes.unsafe_to_string message) l.out;
  l.waiting <- l.waiting + head + n;
  flush l

(* {1 Reading} *)

let length l at =
  let n = Int32.to_int (Bytes.get_int32_le l.input at) land 0xFFFF_FFFF in
  if n > most then
    Failure.refused "owner %d sends a message of %d bytes: %d is the most" (l.peer + 1) n most;
  n

let make_room l =
  if l.have = Bytes.length l.input then begin
    let longer = Bytes.create (2 * l.have) in
    Bytes.blit l.input 0 longer 0 l.have;
    l.input <- longer
  end

(* The messages that are whole, from a place on; and the place behind them. *)
let rec messages l each at =
  if l.have - at < head then at
  else
    let n = length l at in
    if l.have - at - head < n then at
    else begin
      each (Bytes.get l.input (at + 4)) (Bytes.sub_string l.input (at + head) n);
      messages l each (at + head + n)
    end

let receive l each =
  make_room l;
  match Unix.read l.fd l.input l.have (Bytes.length l.input - l.have) with
  | 0 -> gone l
  | n ->
    l.have <- l.have + n;
    let at = messages l each 0 in
    Bytes.blit l.input at l.input 0 (l.have - at);
    l.have <- l.have - at
  | exception Unix.Unix_error ((EAGAIN | EWOULDBLOCK | EINTR), _, _) -> ()
  | exception Unix.Unix_error _ -> gone l
