open Lwt.Syntax

type t = {
  pid : int;
  input : Lwt_io.output_channel;
  output : Lwt_io.input_channel;
  turn : Lwt_mutex.t;  (** of who asks *)
  mutable waiting : int;
  mutable alive : bool;
  gone : unit Lwt.t;
}

type failure = Over | Too_slow | Busy

let most_waiting = 64

let signal t number = if t.alive then try Unix.kill t.pid number with Unix.Unix_error _ -> ()
let kill t = signal t Sys.sigkill
let interrupt t = signal t Sys.sigint
let alive t = t.alive

let rec waited pid =
  Lwt.catch
    (fun () -> Lwt.map ignore (Lwt_unix.waitpid [] pid))
    (function Unix.Unix_error (EINTR, _, _) -> waited pid | _ -> Lwt.return_unit)

let close channel = Lwt.catch (fun () -> Lwt_io.close channel) (fun _ -> Lwt.return_unit)

(* A process begins with SIGINT held back: one that comes before it can take it waits. *)
let create arguments input output =
  let before = Unix.sigprocmask SIG_BLOCK [ Sys.sigint ] in
  Fun.protect
    ~finally:(fun () -> ignore (Unix.sigprocmask SIG_SETMASK before))
    (fun () -> Unix.create_process Sys.executable_name arguments input output Unix.stderr)

(* All or none of what a process needs, where the system has not enough of it. *)
let or_else_close fds f =
  match f () with
  | x -> x
  | exception e ->
    List.iter Unix.close fds;
    raise e

let start arguments =
  let their_input, input = Unix.pipe ~cloexec:true () in
  let output, their_output = or_else_close [ their_input; input ] (fun () -> Unix.pipe ~cloexec:true ()) in
  let all = [ their_input; input; output; their_output ] in
  let pid = or_else_close all (fun () -> create arguments their_input their_output) in
  Unix.close their_input;
  Unix.close their_output;
  let channel mode fd = Lwt_io.of_fd ~mode (Lwt_unix.of_unix_file_descr fd) in
  let gone, wake = Lwt.wait () in
  let t =
    {
      pid;
      input = channel Lwt_io.output input;
      output = channel Lwt_io.input output;
      turn = Lwt_mutex.create ();
      waiting = 0;
      alive = true;
      gone;
    }
  in
  Lwt.async (fun () ->
      let* () = waited pid in
      t.alive <- false;
      Lwt.wakeup_later wake ();
      close t.input);
  t

let discard t =
  kill t;
  let* () = t.gone in
  close t.output

let say t line =
  Lwt.catch
    (fun () ->
       let* () = Lwt_io.write_line t.input line in
       Lwt_io.flush t.input)
    (fun _ -> Lwt.return_unit)

let hear t = Lwt.catch (fun () -> Lwt_io.read_line_opt t.output) (fun _ -> Lwt.return_none)

(* One that is late would answer the next question with what belongs to this one: it is ended. *)
let answered t ~seconds line =
  if not t.alive then Lwt.return_error Over
  else
    let answer () =
      let* () = say t line in
      Lwt.map (Option.to_result ~none:Over) (hear t)
    in
    Lwt.catch
      (fun () -> Lwt_unix.with_timeout seconds answer)
      (fun _ ->
         Lwt.map (fun () -> Error Too_slow) (discard t))

let ask t ~seconds line =
  if t.waiting >= most_waiting then Lwt.return_error Busy
  else begin
    t.waiting <- t.waiting + 1;
    (* Whoever asks may go away: the answer is read all the same, or the next one would get it. *)
    Lwt.no_cancel
      (Lwt.finalize
         (fun () -> Lwt_mutex.with_lock t.turn (fun () -> answered t ~seconds line))
         (fun () ->
            t.waiting <- t.waiting - 1;
            Lwt.return_unit))
  end
