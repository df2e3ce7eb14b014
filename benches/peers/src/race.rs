//! The race: all take turns at the same rays, and each is compared with Embree in the same round.

use crate::racer::{MISS, Query, Question, Racer};
use crate::sets::Set;
use rustix::time::{ClockId, clock_gettime};

/// Rays between two changes of turns: a few milliseconds, in which neither another load of the machine changes much
/// nor the filling of the caches costs much.
const TURN: usize = 8192;

/// One that is slower than Embree by more than this factor only runs a part of the turns, evenly chosen; and where one turn is still too
/// long, in a part of the rounds.
const PATIENCE: f64 = 8.0;

/// What came of one racer, set and query.
#[derive(Clone, Debug)]
pub(crate) struct Lap {
    /// Its place among the racers.
    pub racer: usize,
    /// What was asked.
    pub query: Query,
    /// Its rays per second, divided by those of Embree in the same round; of each round in which it ran.
    pub ratios: Ratios,
    /// Its rays per second, from the same median.
    pub speed: f64,
    /// The part of the rays on which it agrees with Embree.
    pub agree: f64,
}

/// A ratio of speeds for each round, of one or more.
#[derive(Clone, Debug)]
pub(crate) struct Ratios(Vec<f64>);

impl Ratios {
    /// The ratios of another one's times to this one's, round by round.
    pub(crate) fn of(theirs: &[f64], ours: &[f64]) -> Self {
        Self(theirs.iter().zip(ours).map(|(t, o)| t / o).collect())
    }

    /// A ratio that is the same in every round.
    pub(crate) fn once(ratio: f64) -> Self {
        Self(vec![ratio])
    }

    /// The median of the rounds.
    pub(crate) fn median(&self) -> f64 {
        median(self.0.clone())
    }

    /// What a tenth and nine tenths of the rounds are below.
    pub(crate) fn spread(&self) -> [f64; 2] {
        [0.1, 0.9].map(|part| quantile(self.0.clone(), part))
    }

    /// The ratios of this one's speed to another one's, in the rounds in which both ran: both are ratios to the same speeds.
    pub(crate) fn to(&self, other: &Self) -> Self {
        let both = self.0.iter().zip(&other.0);
        Self(both.map(|(ours, theirs)| ours / theirs).collect())
    }
}

/// Lets all run over the set for a number of rounds; the first of the racers is Embree, and in each of its laps the ratio is 1.
///
/// `scale` is a length of the scene: distances agree within 10⁻⁵ of it and of themselves.
pub(crate) fn race(set: &Set, racers: &[Box<dyn Racer>], rounds: usize, scale: f32) -> Vec<Lap> {
    let turns: Vec<&[Question]> = set.questions.chunks(TURN).collect();
    if turns.is_empty() {
        return Vec::new();
    }
    let mut runners: Vec<Runner> = Vec::new();
    for &query in set.queries {
        for (racer, structure) in racers.iter().enumerate() {
            let mut answers = Vec::new();
            let once = &turns[0][..turns[0].len().min(64)];
            if structure.run(query, once, &mut answers) {
                runners.push(Runner::new(racer, query, turns.len(), rounds));
            }
        }
    }
    let mut expected = Vec::new();
    let mut answers = Vec::new();
    for round in 0..rounds {
        for (turn, questions) in turns.iter().enumerate() {
            if round == 0 {
                racers[0].run(set.queries[0], questions, &mut expected);
            }
            for i in 0..runners.len() {
                // Nobody always follows the same one.
                let i = (i + turn + round) % runners.len();
                let runner = &mut runners[i];
                if !turn.is_multiple_of(runner.every) || round >= runner.rounds {
                    continue;
                }
                let start = seconds();
                racers[runner.racer].run(runner.query, questions, &mut answers);
                runner.times[turn].push(seconds() - start);
                if round == 0 {
                    runner.compare(questions, &expected, &answers, scale);
                }
            }
            if round == 0 && turn == 0 {
                let embree = runners[0].times[0][0];
                for runner in &mut runners {
                    let slowness = runner.times[0][0] / embree / PATIENCE;
                    runner.every = (slowness.ceil() as usize).clamp(1, turns.len());
                    let too_long = slowness / turns.len() as f64;
                    runner.rounds = (rounds as f64 / too_long).clamp(1.0, rounds as f64) as usize;
                }
            }
        }
    }
    let embree = runners[0].clone();
    let lap = |runner: &Runner| runner.lap(&embree, &turns);
    runners.iter().map(lap).collect()
}

#[derive(Clone)]
struct Runner {
    racer: usize,
    query: Query,
    /// It runs in one turn of this number.
    every: usize,
    /// It runs in this number of rounds, the first ones.
    rounds: usize,
    /// Seconds of processor time: of each turn, of each round.
    times: Vec<Vec<f64>>,
    same: usize,
    asked: usize,
}

impl Runner {
    fn new(racer: usize, query: Query, turns: usize, rounds: usize) -> Self {
        Self {
            racer,
            query,
            every: 1,
            rounds,
            times: vec![Vec::new(); turns],
            same: 0,
            asked: 0,
        }
    }

    fn compare(&mut self, questions: &[Question], expected: &[f32], answers: &[f32], scale: f32) {
        /// Relative: what different orders of rounding do, but for rays that graze.
        const TOLERANCE: f32 = 1e-5;
        let same = |(&a, &b): (&f32, &f32)| {
            (a == MISS && b == MISS) || (a - b).abs() <= TOLERANCE * (a.abs() + scale)
        };
        self.asked += questions.len();
        self.same += expected
            .iter()
            .zip(answers)
            .filter(|pair| same(*pair))
            .count();
    }

    fn lap(&self, embree: &Self, turns: &[&[Question]]) -> Lap {
        let (mut ratios, mut speeds) = (Vec::new(), Vec::new());
        for round in 0..self.rounds {
            let (mut ours, mut theirs, mut rays) = (0.0, 0.0, 0);
            for turn in (0..turns.len()).step_by(self.every) {
                ours += self.times[turn][round];
                theirs += embree.times[turn][round];
                rays += turns[turn].len();
            }
            ratios.push(theirs / ours);
            speeds.push(rays as f64 / ours);
        }
        Lap {
            racer: self.racer,
            query: self.query,
            ratios: Ratios(ratios),
            speed: median(speeds),
            agree: self.same as f64 / self.asked as f64,
        }
    }
}

/// The middle one of the numbers; of two middle ones, the mean.
fn median(numbers: Vec<f64>) -> f64 {
    quantile(numbers, 0.5)
}

/// The number below which this part of all is; between two of them, on the line from one to the other.
fn quantile(mut numbers: Vec<f64>, part: f64) -> f64 {
    numbers.sort_by(f64::total_cmp);
    let at = part * (numbers.len() - 1) as f64;
    let (low, high) = (numbers[at.floor() as usize], numbers[at.ceil() as usize]);
    low + at.fract() * (high - low)
}

/// Seconds of processor time that this thread has had: what others do meanwhile does not count.
fn seconds() -> f64 {
    let now = clock_gettime(ClockId::ThreadCPUTime);
    now.tv_sec as f64 + 1e-9 * now.tv_nsec as f64
}
