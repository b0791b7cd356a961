"""A resources server for NeMo Gym that verifies answers to physics problems."""

from nemo_gym.base_resources_server import (
    BaseResourcesServerConfig,
    BaseVerifyRequest,
    BaseVerifyResponse,
    SimpleResourcesServer,
)

from sim2reason.rewards import score


class ProblemRequest(BaseVerifyRequest):
    """A request with a response, and the ground truth by which it is graded."""

    ground_truth: str


class ProblemResponse(BaseVerifyResponse):
    """The reward of a response, with the outcome and a sentence that explain it."""

    outcome: str
    why: str


class Sim2ReasonResourcesServer(SimpleResourcesServer):
    """A server that grades the boxed answers of responses: reward 1 or 0."""

    config: BaseResourcesServerConfig

    async def verify(self, body: ProblemRequest) -> ProblemResponse:
        """Grade the text of a response."""
        grade = score(body.ground_truth, body.response.output_text)
        return ProblemResponse(**body.model_dump(), reward=grade.reward, outcome=grade.outcome, why=grade.why)


if __name__ == "__main__":
    Sim2ReasonResourcesServer.run_webserver()
